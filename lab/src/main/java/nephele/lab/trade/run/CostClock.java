package nephele.lab.trade.run;

/** What the running thread has taken so far; differences of two readings are costs. */
interface CostClock {
    long cpuNanos();

    long wallNanos();

    long allocatedBytes();
}
