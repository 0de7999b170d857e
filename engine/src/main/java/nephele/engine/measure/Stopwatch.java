package nephele.engine.measure;

import com.sun.management.OperatingSystemMXBean;
import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;

/** What the JVM knows about the time and the memory that have been used. */
public final class Stopwatch {
    private final OperatingSystemMXBean process = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
    private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    /** CPU time of the whole process; advances in steps of 10 ms. */
    public long processCpuNanos() {
        return process.getProcessCpuTime();
    }

    /** CPU time of the calling thread. */
    public long threadCpuNanos() {
        return threads.getCurrentThreadCpuTime();
    }

    /** Bytes that the calling thread has allocated since it began. */
    public long allocatedBytes() {
        return threads.getCurrentThreadAllocatedBytes();
    }
}
