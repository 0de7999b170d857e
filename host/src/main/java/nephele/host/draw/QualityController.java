package nephele.host.draw;

import java.util.Arrays;
import java.util.Optional;

/**
 * Holds a frame rate by choosing among the points of a {@link QualityFront}. It knows nothing but the costs of the
 * frames: it goes down after a few frames over budget, and up when nearly all of many frames would stay within the
 * budget, at most once in {@value #CLIMB_SECONDS} s; each climb that fails doubles that time. What it learns of a level
 * chooses the point of the first frame the next time.
 */
public final class QualityController {
    /** Frames after a change that are not counted: programs are compiled and targets allocated in them. */
    static final int WARM_UP_FRAMES = 3;

    /** Frames at the beginning of a level that are not counted: the virtual machine compiles its code in them, too. */
    static final int FIRST_WARM_UP_FRAMES = 8;

    /** Frames of the first decision, which may go to any point. */
    static final int FIRST_FRAMES = 8;

    /** Frames of a decision to climb. */
    static final int WINDOW_FRAMES = 90;

    /** Recent frames, and how many of them over budget make it go down. */
    private static final int RECENT_FRAMES = 8;

    private static final int TOO_SLOW_FRAMES = 5;
    /** Frames over budget in the whole window that make it go down. */
    private static final int TOO_SLOW_IN_WINDOW = 7;

    /** The fraction of the budget that the first decision and a way down aim at, and that a climb may need. */
    private static final double AIM = 0.8;

    /** The quantile of frame costs that a climb regards; the frames above it are hitches of the system. */
    private static final double USUALLY = 0.97;

    /** The last windows from which a level's cost is learned: ten minutes at 30 frames a second. */
    private static final int LEARNED_WINDOWS = 200;

    private static final double LEARNED_FRACTION = 0.75;

    private static final double CLIMB_SECONDS = 10;
    private static final double LONGEST_CLIMB_SECONDS = 320;

    private final QualityFront front;
    private final double[] window = new double[WINDOW_FRAMES];
    private final double[] sorted = new double[WINDOW_FRAMES];
    private double budgetMillis;
    private int point;
    private boolean isFirst;
    private boolean hasClimbed;
    private int warmUp;
    private int frames;
    private double secondsAtPoint;
    private double climbSeconds = CLIMB_SECONDS;
    private final double[] learned = new double[LEARNED_WINDOWS];
    private int learnedWindows;

    /** @param budgetMillis greatest time of a frame */
    public QualityController(QualityFront front, double budgetMillis) {
        this.front = front;
        this.budgetMillis = budgetMillis;
        point = front.start();
        begin();
    }

    /** Begins another level: its first frames decide anew. */
    public void begin() {
        isFirst = true;
        hasClimbed = false;
        climbSeconds = CLIMB_SECONDS;
        learnedWindows = 0;
        restart(FIRST_WARM_UP_FRAMES);
    }

    /**
     * Begins another level whose cost is known: its first frame is drawn at the point that fits.
     *
     * @param highMillis what its frames usually cost at most at quality {@code high}
     */
    public void begin(double highMillis) {
        begin();
        isFirst = false;
        point = bestWithin(
                AIM * budgetMillis, highMillis * point().cost(), front.points().size() - 1);
    }

    /**
     * Returns what the frames since the level's begin usually cost at most, as if drawn at quality {@code high}, ms: that of
     * three quarters of the windows, so that hitches weigh little. 0 before a window is full.
     */
    public double learnedHighMillis() {
        int count = Math.min(learnedWindows, LEARNED_WINDOWS);
        double[] rising = Arrays.copyOf(learned, count);
        Arrays.sort(rising);
        return count == 0 ? 0 : rising[(int) Math.round(LEARNED_FRACTION * (count - 1))];
    }

    /** Returns what quality {@code high} would cost where a frame of the current point costs {@code millis}. */
    public double atHigh(double millis) {
        return millis / point().cost();
    }

    private void restart(int uncounted) {
        warmUp = uncounted;
        frames = 0;
        secondsAtPoint = 0;
    }

    /** Sets another budget; the next frames decide anew if it differs. */
    public void budgetMillis(double newBudget) {
        if (newBudget != budgetMillis) {
            budgetMillis = newBudget;
            begin();
        }
    }

    /** Returns true if no point is cheaper than that for the next frame. */
    public boolean isCheapest() {
        return point == 0;
    }

    /** Returns the point for the next frame. */
    public QualityFront.Point point() {
        return front.points().get(point);
    }

    /**
     * Adds a frame.
     *
     * @param millis its cost
     * @param seconds time since the previous frame
     * @return true if another point was chosen
     */
    public boolean add(double millis, double seconds) {
        frames++;
        secondsAtPoint += seconds;
        if (frames <= warmUp) {
            return false;
        }
        window[(frames - warmUp - 1) % WINDOW_FRAMES] = millis;
        if ((frames - warmUp) % WINDOW_FRAMES == 0) {
            learned[learnedWindows++ % LEARNED_WINDOWS] = atHigh(quantile(USUALLY));
        }
        return change(isFirst ? first() : next());
    }

    private int counted() {
        return Math.min(frames - warmUp, WINDOW_FRAMES);
    }

    private int first() {
        if (counted() < FIRST_FRAMES) {
            return point;
        }
        isFirst = false;
        return bestWithin(AIM * budgetMillis, quantile(0.5), front.points().size() - 1);
    }

    private int next() {
        if (isTooSlow()) {
            int below = Math.max(point - 1, 0);
            return bestWithin(AIM * budgetMillis, recentMedian(), below);
        }
        boolean mayClimb = point + 1 < front.points().size()
                && counted() == WINDOW_FRAMES
                && secondsAtPoint >= climbSeconds
                && predicted(quantile(USUALLY), point + 1) <= AIM * budgetMillis;
        return mayClimb ? point + 1 : point;
    }

    private boolean change(int next) {
        if (next == point) {
            return false;
        }
        if (next < point && hasClimbed && secondsAtPoint < 2 * climbSeconds) {
            climbSeconds = Math.min(2 * climbSeconds, LONGEST_CLIMB_SECONDS);
        }
        hasClimbed = next > point;
        point = next;
        restart(WARM_UP_FRAMES);
        return true;
    }

    /** Returns the best point, no better than {@code most}, that is predicted to cost no more. */
    private int bestWithin(double millis, double costHere, int most) {
        for (int i = most; i > 0; i--) {
            if (predicted(costHere, i) <= millis) {
                return i;
            }
        }
        return 0;
    }

    private double predicted(double costHere, int other) {
        return costHere * front.points().get(other).cost() / point().cost();
    }

    private boolean isTooSlow() {
        int last = frames - warmUp - 1;
        int recent = 0;
        for (int i = 0; i < Math.min(RECENT_FRAMES, counted()); i++) {
            recent += window[(last - i) % WINDOW_FRAMES] > budgetMillis ? 1 : 0;
        }
        return recent >= TOO_SLOW_FRAMES || overBudget() >= TOO_SLOW_IN_WINDOW;
    }

    private int overBudget() {
        int over = 0;
        for (int i = 0; i < counted(); i++) {
            over += window[i] > budgetMillis ? 1 : 0;
        }
        return over;
    }

    private double recentMedian() {
        int last = frames - warmUp - 1;
        int size = Math.min(RECENT_FRAMES, counted());
        for (int i = 0; i < size; i++) {
            sorted[i] = window[(last - i) % WINDOW_FRAMES];
        }
        Arrays.sort(sorted, 0, size);
        return sorted[size / 2];
    }

    private double quantile(double fraction) {
        int size = counted();
        System.arraycopy(window, 0, sorted, 0, size);
        Arrays.sort(sorted, 0, size);
        return sorted[(int) Math.round(fraction * (size - 1))];
    }

    /** Returns the cost that nearly all of the last frames stay below, ms; 0 before any was measured. */
    public double slowestMillis() {
        return counted() <= 0 ? 0 : quantile(USUALLY);
    }

    /** Returns the greatest time of a frame, ms. */
    public double budgetMillis() {
        return budgetMillis;
    }

    /** Returns the next better point; empty if there is none. */
    public Optional<QualityFront.Point> better() {
        return point + 1 < front.points().size() ? Optional.of(front.points().get(point + 1)) : Optional.empty();
    }

    /** Returns what {@link #slowestMillis} would be at the next better point. */
    public double betterMillis() {
        return predicted(slowestMillis(), point + 1);
    }
}
