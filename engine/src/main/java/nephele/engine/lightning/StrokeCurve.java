package nephele.engine.lightning;

import nephele.engine.level.appearance.FlashStyle;
import nephele.engine.math.Chance;

/**
 * The brightness of a strike over its age: two to four return strokes within 0.2 to 0.4 s, each of which decays
 * exponentially, and a continuing current that decays more slowly (the numbers are typical ones of Rakov and Uman 2003,
 * "Lightning: Physics and Effects", table 1.1 and section 4.6, with the decay of a stroke lengthened to that of the light
 * which clouds scatter). The first stroke is the strongest and reaches 1. Brightness is the mean over the exposure of a
 * film, so that it depends little on when a frame falls between strokes.
 */
public final class StrokeCurve {
    /** A strike is dark from this age on. */
    public static final double LONGEST_SECONDS = 1.2;

    /** The time over which brightness is averaged. */
    public static final double EXPOSED_SECONDS = 1.0 / 60;

    private static final int MOST_STROKES = 4;
    private static final double CONTINUING_FRACTION = 0.12;
    private static final double CONTINUING_DECAY = 0.16;
    private static final double BRANCH_DECAY = 0.03;
    private static final double SOFT_FRACTION = 0.2;
    private static final double SOFT_RISE = 0.12;
    private static final double SOFT_DECAY = 0.3;

    private final double[] begin = new double[MOST_STROKES];
    private final double[] weight = new double[MOST_STROKES];
    private final double[] decay = new double[MOST_STROKES];
    private int strokes;

    /** Takes another strike. @param dice of {@link Chance} */
    void follow(long dice) {
        strokes = 2 + (int) (3 * Chance.unit(dice, 60));
        double span = 0.2 + 0.2 * Chance.unit(dice, 61);
        for (int i = 0; i < strokes; i++) {
            double even = i * span / (strokes - 1);
            boolean isInner = i > 0 && i < strokes - 1;
            begin[i] = even + (isInner ? 0.3 * span / (strokes - 1) * Chance.signed(dice, 70 + i) : 0);
            weight[i] = i == 0 ? 1 : 0.3 + 0.5 * Chance.unit(dice, 80 + i);
            decay[i] = 0.035 + 0.025 * Chance.unit(dice, 90 + i);
        }
    }

    /** Returns the number of return strokes. */
    public int strokes() {
        return strokes;
    }

    /** Returns the age at which a stroke begins. */
    public double beginSeconds(int stroke) {
        return begin[stroke];
    }

    /** Returns the brightness at an age, 0 to a little over 1. */
    double brightness(double age, FlashStyle style) {
        if (!(age > 0 && age < LONGEST_SECONDS)) {
            return 0;
        }
        return switch (style) {
            case NATURAL -> (1 - CONTINUING_FRACTION) * ofStrokes(age) + continuing(age);
            case SOFTENED -> softened(age);
        };
    }

    private double ofStrokes(double age) {
        double sum = 0;
        for (int i = 0; i < strokes; i++) {
            sum += weight[i] * exposed(age - begin[i], decay[i]);
        }
        return sum * ending(age);
    }

    private static double continuing(double age) {
        return CONTINUING_FRACTION * exposed(age, CONTINUING_DECAY) * ending(age);
    }

    /** Returns the brightness of branches, through which only the first stroke goes. */
    double branchBrightness(double age, FlashStyle style) {
        return switch (style) {
            case NATURAL -> exposed(age, BRANCH_DECAY) * ending(age);
            case SOFTENED -> brightness(age, style);
        };
    }

    private static double softened(double age) {
        double rise = Math.min(1, age / SOFT_RISE);
        return SOFT_FRACTION * rise * rise * (3 - 2 * rise) * Math.exp(-age / SOFT_DECAY) * ending(age);
    }

    /** Returns the mean of exp(−t / decay) for t ≥ 0 over the exposure that ends at an age. */
    static double exposed(double age, double decaySeconds) {
        if (age <= 0) {
            return 0;
        }
        double since = Math.max(0, age - EXPOSED_SECONDS);
        return (Math.exp(-since / decaySeconds) - Math.exp(-age / decaySeconds)) * decaySeconds / EXPOSED_SECONDS;
    }

    /** Returns a factor that brings the light to 0 at the longest age. */
    private static double ending(double age) {
        double fraction = age / LONGEST_SECONDS;
        double left = Math.max(0, 1 - fraction * fraction);
        return left * left;
    }
}
