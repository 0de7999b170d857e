package nephele.engine.sim;

/** Told when a tick went wrong and was undone. */
@FunctionalInterface
public interface FaultLog {
    FaultLog SILENT = (tick, what) -> {};

    void fault(long tick, String what);
}
