package nephele.engine.lightning;

import nephele.engine.level.Environment.Lightning;
import nephele.engine.level.appearance.FlashStyle;
import nephele.engine.math.Chance;

/**
 * The lightning of a level at a time. Strike n begins at a random time of the n-th interval of equal length, early
 * enough to be dark before the interval ends.
 */
public final class LevelLightning {
    private static final long NO_STRIKE = Long.MIN_VALUE;
    private static final int BEGIN = 50;

    private final Lightning lightning;
    private final double intervalSeconds;
    private final Bolt bolt = new Bolt();
    private final StrokeCurve strokes = new StrokeCurve();
    private long strike = NO_STRIKE;
    private double brightness;
    private double branchBrightness;

    /** @param lightning that strikes */
    public LevelLightning(Lightning lightning) {
        this.lightning = lightning;
        intervalSeconds = 60 / lightning.strikesPerMinute();
    }

    /** Takes a time; before 0 nothing strikes. */
    public void at(double seconds, FlashStyle style) {
        long now = (long) Math.floor(seconds / intervalSeconds);
        double age = seconds < 0 ? -1 : seconds - beginSeconds(now);
        boolean isVisible = age > 0 && age < StrokeCurve.LONGEST_SECONDS;
        if (isVisible && now != strike) {
            strike = now;
            long dice = Chance.dice(lightning.seed(), now);
            strokes.follow(dice);
            bolt.follow(lightning, dice);
        }
        brightness = isVisible ? strokes.brightness(age, style) : 0;
        branchBrightness = isVisible ? strokes.branchBrightness(age, style) : 0;
    }

    /** Returns the time at which a strike begins. */
    public double beginSeconds(long number) {
        double late = Chance.unit(Chance.dice(lightning.seed(), number), BEGIN);
        return number * intervalSeconds + late * (intervalSeconds - StrokeCurve.LONGEST_SECONDS);
    }

    /** Returns the description in the level. */
    public Lightning lightning() {
        return lightning;
    }

    /** Returns the number of the strike whose {@link #bolt} is known. */
    public long strike() {
        return strike;
    }

    /** Returns true if a strike is visible. */
    public boolean isLit() {
        return brightness > 0;
    }

    /** Returns the brightness of the main channel and of the light of the whole, 0 to a little over 1. */
    public double brightness() {
        return brightness;
    }

    /** Returns the brightness of branches. */
    public double branchBrightness() {
        return branchBrightness;
    }

    /** Returns the channel of the last strike that was visible. */
    public Bolt bolt() {
        return bolt;
    }

    /** Returns the strokes of that strike. */
    public StrokeCurve strokes() {
        return strokes;
    }
}
