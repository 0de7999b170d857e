/**
 * Where the player's eye can be: {@link nephele.engine.sim.reach.EyeReach}, a bound from above in boxes, found by a flood
 * through the free space of a level, its portals and those that can be shot.
 */
package nephele.engine.sim.reach;
