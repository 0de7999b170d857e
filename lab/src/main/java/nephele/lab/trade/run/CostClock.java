package nephele.lab.trade.run;

/** A clock of the resources that the running thread has used so far; a cost is the difference of two readings. */
interface CostClock {
    long cpuNanos();

    long wallNanos();

    long allocatedBytes();
}
