/**
 * The simulation of player, bodies and portal gun: {@link nephele.engine.sim.Simulation#step} maps a state and an input
 * to the next state. It uses fixed ticks, double precision and no clock. Every state has a 64-bit hash, equal on every
 * machine, so replays repeat exactly.
 */
package nephele.engine.sim;
