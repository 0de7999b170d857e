package nephele.workshop.prove.bodies;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.function.Supplier;

/**
 * The cost of bodies for the simulating thread, measured after warm-up.
 *
 * @param millisecondsPerTwoTicks mean CPU time of 1/60 s
 */
record BodyCost(double millisecondsPerTwoTicks, double bytesPerBodyAndTick) {
    private static final int WARM_ROUNDS = 6;

    /** The bodies of a run and the code that advances them by a tick. */
    record Course(int bodies, Runnable tick) {}

    static BodyCost measure(Supplier<Course> course, int ticks) {
        for (int round = 0; round < WARM_ROUNDS; round++) {
            run(course.get(), ticks);
        }
        return run(course.get(), ticks);
    }

    private static BodyCost run(Course course, int ticks) {
        var thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long bytes = thread.getCurrentThreadAllocatedBytes();
        long nanos = thread.getCurrentThreadCpuTime();
        for (int tick = 0; tick < ticks; tick++) {
            course.tick().run();
        }
        nanos = thread.getCurrentThreadCpuTime() - nanos;
        bytes = thread.getCurrentThreadAllocatedBytes() - bytes;
        return new BodyCost(nanos / 1e6 / ticks * 2, (double) bytes / ticks / course.bodies());
    }
}
