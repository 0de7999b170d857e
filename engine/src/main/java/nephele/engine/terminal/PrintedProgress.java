package nephele.engine.terminal;

import java.io.PrintStream;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.DoubleConsumer;

/** Prints the progress of long work in steps of ten per cent; prints nothing if there is no work. */
public final class PrintedProgress implements DoubleConsumer {
    private static final int STEP_PERCENT = 10;

    private final PrintStream to;
    private final String work;
    private final AtomicInteger printedSteps = new AtomicInteger();

    private PrintedProgress(PrintStream to, String work) {
        this.to = to;
        this.work = work;
    }

    /** Returns the progress of the bake of a level's light, which runs only if the light is not cached. */
    public static PrintedProgress ofBake(PrintStream to) {
        return new PrintedProgress(to, "baking the level's light");
    }

    /** Returns the progress of a reference picture. */
    public static PrintedProgress ofTrace(PrintStream to) {
        return new PrintedProgress(to, "tracing the reference");
    }

    @Override
    public void accept(double share) {
        int step = (int) (share * 100 / STEP_PERCENT);
        int before = printedSteps.getAndUpdate(printed -> Math.max(printed, step));
        if (step > before) {
            to.println(work + ": " + step * STEP_PERCENT + " %");
        }
    }
}
