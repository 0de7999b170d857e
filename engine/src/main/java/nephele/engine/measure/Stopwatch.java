package nephele.engine.measure;

import com.sun.management.OperatingSystemMXBean;
import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;

/** Measures CPU time and allocations as reported by the JVM. */
public final class Stopwatch {
    private final OperatingSystemMXBean process = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
    private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    /** Returns the CPU time of the whole process; it advances in steps of 10 ms. */
    public long processCpuNanos() {
        return process.getProcessCpuTime();
    }

    /** Returns the CPU time of the calling thread. */
    public long threadCpuNanos() {
        return threads.getCurrentThreadCpuTime();
    }

    /** Returns the bytes that the calling thread has allocated since it began. */
    public long allocatedBytes() {
        return threads.getCurrentThreadAllocatedBytes();
    }
}
