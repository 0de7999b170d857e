/**
 * The simulation of player, bodies and portal gun: a state and an input give the next state. It uses fixed ticks,
 * double precision and no clock; every state has a 64-bit hash, equal on every machine, so replays repeat exactly.
 */
package nephele.engine.sim;
