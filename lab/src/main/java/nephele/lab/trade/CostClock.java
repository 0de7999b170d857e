package nephele.lab.trade;

/** A clock of CPU time, wall time and bytes allocated by the running thread; differences of readings are costs. */
interface CostClock {
    long cpuNanos();

    long wallNanos();

    long allocatedBytes();
}
