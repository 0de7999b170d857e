package nephele.app.levels;

import java.io.PrintStream;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.DoubleConsumer;

/** Tells a terminal how far the light of a level is baked, in steps of ten per cent. Silent when nothing is baked. */
public final class PrintedBake implements DoubleConsumer {
    private static final int STEP_PERCENT = 10;

    private final PrintStream to;
    private final AtomicInteger printedSteps = new AtomicInteger();

    public PrintedBake(PrintStream to) {
        this.to = to;
    }

    @Override
    public void accept(double share) {
        int step = (int) (share * 100 / STEP_PERCENT);
        int before = printedSteps.getAndUpdate(printed -> Math.max(printed, step));
        if (step > before) {
            to.println("baking the level's light: " + step * STEP_PERCENT + " %");
        }
    }
}
