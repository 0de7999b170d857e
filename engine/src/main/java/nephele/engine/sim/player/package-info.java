/**
 * The movement of the player in a tick: view angles, walking, jumping, falling, steps, pushes on bodies, and the
 * passage through portals. {@link nephele.engine.sim.player.PlayerStep} calls the parts in order.
 */
package nephele.engine.sim.player;
