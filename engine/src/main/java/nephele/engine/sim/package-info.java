/** The game's rules over time: fixed ticks, double precision, no clock, a 64-bit hash of every state. */
package nephele.engine.sim;
