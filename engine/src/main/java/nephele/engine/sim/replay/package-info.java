/** Recorded input, its playback, and the hashes and dumps of state that prove two runs equal. */
package nephele.engine.sim.replay;
