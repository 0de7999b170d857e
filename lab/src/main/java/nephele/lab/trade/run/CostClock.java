package nephele.lab.trade.run;

/** Readings of CPU time, wall time and bytes allocated by the running thread; a cost is the difference of two readings. */
interface CostClock {
    long cpuNanos();

    long wallNanos();

    long allocatedBytes();
}
