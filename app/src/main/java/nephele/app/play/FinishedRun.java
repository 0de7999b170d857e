package nephele.app.play;

/**
 * A level played to its exit.
 *
 * @param ticks simulated time from the start to the exit, in ticks of 1/120 s
 * @param portals number of portals shot
 * @param hints number of hints taken
 */
record FinishedRun(long ticks, int portals, int hints) {}
