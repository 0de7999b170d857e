/**
 * The values that the simulation reads and returns: player and world state, input, actions, events and settings. {@link
 * nephele.engine.sim.state.SimState} is the whole state of a tick and has a 64-bit hash.
 */
package nephele.engine.sim.state;
