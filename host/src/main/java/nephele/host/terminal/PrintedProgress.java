package nephele.host.terminal;

import java.io.PrintStream;
import java.util.function.DoubleConsumer;
import java.util.function.LongSupplier;

/**
 * Prints the progress of long work: every ten per cent, and at least every half minute; with the time that is left if the
 * rest takes as long as what was done. Prints nothing if there is no work.
 */
public final class PrintedProgress implements DoubleConsumer {
    private static final int STEP_PERCENT = 10;
    private static final double MOST_SILENCE_SECONDS = 30;

    /** Least remaining time that is worth mentioning. */
    private static final double LEAST_SECONDS = 5;

    private final PrintStream to;
    private final String work;
    private final double fractionBefore;
    private final LongSupplier nanoseconds;
    private final long start;
    private int printedPercent;
    private double printedSeconds;

    /**
     * @param fractionBefore 0–1, done before this run
     * @param nanoseconds a clock
     */
    PrintedProgress(PrintStream to, String work, double fractionBefore, LongSupplier nanoseconds) {
        this.to = to;
        this.work = work;
        this.fractionBefore = fractionBefore;
        this.nanoseconds = nanoseconds;
        start = nanoseconds.getAsLong();
        printedPercent = percent(fractionBefore);
    }

    /** Returns the progress of other work. */
    public static PrintedProgress of(PrintStream to, String work) {
        return of(to, work, 0);
    }

    /**
     * Returns the progress of other work of which a part is done.
     *
     * @param fractionBefore 0–1
     */
    public static PrintedProgress of(PrintStream to, String work, double fractionBefore) {
        return new PrintedProgress(to, work, fractionBefore, System::nanoTime);
    }

    /** Returns the progress of the bake of a level's light, which runs only if the light is not cached. */
    public static PrintedProgress ofBake(PrintStream to) {
        return new PrintedProgress(to, "baking the level's light", 0, System::nanoTime);
    }

    /** Returns the progress of a reference picture. */
    public static PrintedProgress ofTrace(PrintStream to) {
        return ofTrace(to, 0);
    }

    /**
     * Returns the progress of a reference picture of which a part is done.
     *
     * @param fractionBefore 0–1
     */
    public static PrintedProgress ofTrace(PrintStream to, double fractionBefore) {
        return new PrintedProgress(to, "tracing the reference", fractionBefore, System::nanoTime);
    }

    private static int percent(double fraction) {
        return (int) (fraction * 100);
    }

    /** @param fraction 0–1 of the whole work, what was done before this run included; may be called by any thread */
    @Override
    public synchronized void accept(double fraction) {
        double seconds = (nanoseconds.getAsLong() - start) / 1e9;
        int step = percent(fraction) / STEP_PERCENT * STEP_PERCENT;
        boolean isStep = step > printedPercent;
        boolean isLate = percent(fraction) > printedPercent && seconds - printedSeconds >= MOST_SILENCE_SECONDS;
        if (isStep || isLate) {
            printedPercent = isStep ? step : percent(fraction);
            printedSeconds = seconds;
            to.println(work + ": " + printedPercent + " %" + left(fraction, seconds));
        }
    }

    private String left(double fraction, double seconds) {
        double left = seconds * (1 - fraction) / (fraction - fractionBefore);
        return left >= LEAST_SECONDS && left < Double.POSITIVE_INFINITY ? ", " + duration(left) + " left" : "";
    }

    /** Returns a duration in words, rounded to what matters. */
    static String duration(double seconds) {
        long whole = Math.round(seconds);
        if (whole < 100) {
            return whole + " s";
        }
        long minutes = Math.round(seconds / 60);
        return minutes < 100 ? minutes + " min" : minutes / 60 + " h " + minutes % 60 + " min";
    }
}
