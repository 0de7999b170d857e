package nephele.engine.sim.state;

/** Receives a message for each tick that failed and was undone, or in which bodies froze or time was dropped. */
@FunctionalInterface
public interface FaultLog {
    FaultLog SILENT = (tick, what) -> {};

    void fault(long tick, String what);
}
