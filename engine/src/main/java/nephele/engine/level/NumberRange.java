package nephele.engine.level;

import java.util.List;
import java.util.function.DoubleFunction;
import java.util.stream.Collectors;
import nephele.engine.math.Vec3;

/**
 * The numbers that {@link Range} states: those of one or two intervals, in ascending order.
 *
 * @param leastReach how far the component of a vector that is farthest from zero must be from it; 0 for any vector
 */
public record NumberRange(List<Stretch> stretches, double leastReach) {
    /** The range of a component whose annotation gives no limits: the size of the world in metres. */
    public static final NumberRange WORLD = new NumberRange(List.of(new Stretch(-1e7, 1e7)), 0);

    /** All numbers from {@code min} to {@code max}. */
    public record Stretch(double min, double max) {
        private boolean contains(double number) {
            return number >= min && number <= max;
        }

        private double nearest(double number) {
            return Math.max(min, Math.min(max, number));
        }
    }

    /** Returns what an annotation states. */
    public static NumberRange of(Range declared) {
        Stretch stated = new Stretch(declared.min(), declared.max());
        return switch (declared.shape()) {
            case INTERVAL -> new NumberRange(List.of(stated), 0);
            case OR_ZERO -> new NumberRange(List.of(new Stretch(0, 0), stated), 0);
            case EITHER_SIGN -> new NumberRange(List.of(new Stretch(-declared.max(), -declared.min()), stated), 0);
            case DIRECTION -> new NumberRange(List.of(new Stretch(-declared.max(), declared.max())), declared.min());
        };
    }

    /** Returns true if a number, or a component of a vector, may have this value. */
    public boolean contains(double number) {
        return stretches.stream().anyMatch(stretch -> stretch.contains(number));
    }

    /** Returns true if a vector, whose components are in range, points somewhere where it must. */
    public boolean reaches(Vec3 vector) {
        double x = Math.abs(vector.x());
        return Math.max(x, Math.max(Math.abs(vector.y()), Math.abs(vector.z()))) >= leastReach;
    }

    /** Returns the number in the range that is nearest to another one. */
    public double nearest(double number) {
        double nearest = stretches.get(0).nearest(number);
        for (Stretch stretch : stretches) {
            double other = stretch.nearest(number);
            nearest = Math.abs(other - number) < Math.abs(nearest - number) ? other : nearest;
        }
        return nearest;
    }

    /** Returns the least number. */
    public double min() {
        return stretches.get(0).min();
    }

    /** Returns the greatest number. */
    public double max() {
        return stretches.get(stretches.size() - 1).max();
    }

    /**
     * Returns the range in words.
     *
     * @param from format of an interval, of its least and its greatest number as texts: {@code "from %s to %s"}
     * @param or between two intervals: {@code " or "}
     * @param writer writes a number as its reader writes numbers
     */
    public String text(String from, String or, DoubleFunction<String> writer) {
        return stretches.stream()
                .map(stretch -> stretch.min() == stretch.max()
                        ? writer.apply(stretch.min())
                        : String.format(from, writer.apply(stretch.min()), writer.apply(stretch.max())))
                .collect(Collectors.joining(or));
    }
}
