package nephele.lab.trade;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import nephele.engine.measure.Stopwatch;
import org.lwjgl.system.APIUtil;
import org.lwjgl.system.JNI;
import org.lwjgl.system.MemoryUtil;
import org.lwjgl.system.Platform;

/**
 * CPU time of the running thread or of the whole process, including every thread of the JVM and of the OpenGL driver.
 * On Linux the process clock has a resolution of a nanosecond; elsewhere the JVM's clock is used, with steps of 10 ms.
 */
final class CpuClock implements CostClock {
    /** CLOCK_PROCESS_CPUTIME_ID of Linux. */
    private static final int PROCESS_CPU = 2;

    private final CostMetric.Clock whose;
    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private final Stopwatch stopwatch = new Stopwatch();
    private final long clockGettime = address();
    private final long timespec = clockGettime == 0 ? 0 : MemoryUtil.nmemAllocChecked(2 * Long.BYTES);

    CpuClock(CostMetric.Clock whose) {
        this.whose = whose;
    }

    private static long address() {
        if (Platform.get() != Platform.LINUX || Platform.getArchitecture() != Platform.Architecture.X64) {
            return 0;
        }
        try {
            return APIUtil.apiCreateLibrary("libc.so.6").getFunctionAddress("clock_gettime");
        } catch (UnsatisfiedLinkError otherLibrary) {
            return 0;
        }
    }

    @Override
    public long cpuNanos() {
        if (whose == CostMetric.Clock.THREAD) {
            return threads.getCurrentThreadCpuTime();
        }
        if (clockGettime == 0 || JNI.invokePI(PROCESS_CPU, timespec, clockGettime) != 0) {
            return stopwatch.processCpuNanos();
        }
        return 1_000_000_000L * MemoryUtil.memGetLong(timespec) + MemoryUtil.memGetLong(timespec + Long.BYTES);
    }

    @Override
    public long wallNanos() {
        return System.nanoTime();
    }

    @Override
    public long allocatedBytes() {
        return stopwatch.allocatedBytes();
    }
}
