package nephele.engine.model;

import java.util.Locale;

/** A number that describes a shape: what it means and what it may be. */
public enum ShapeParameter {
    LENGTH("length of a side, in units"),
    RADIUS("radius, in units"),
    HEIGHT("height, in units"),
    TUBE("radius of the tube, in units; less than RADIUS"),
    DIVISIONS("parts that a side is divided into", 1),
    SLICES("parts that the circle around the y axis is divided into", 3),
    STACKS("parts from bottom to top, or around the tube", 1),
    TESSELLATION("parts that each side of a patch is divided into", 1);

    static final int MOST_PARTS = 512;
    private static final double LEAST_MEASURE = 1e-6;

    private final String meaning;
    private final int leastParts;

    ShapeParameter(String meaning) {
        this(meaning, 0);
    }

    ShapeParameter(String meaning, int leastParts) {
        this.meaning = meaning;
        this.leastParts = leastParts;
    }

    public String meaning() {
        return meaning;
    }

    /** Whether it is a whole number. */
    public boolean counts() {
        return leastParts > 0;
    }

    /** @throws IllegalArgumentException with what is wanted instead, for users */
    public double read(String word) {
        try {
            return check(Double.parseDouble(word));
        } catch (NumberFormatException notANumber) {
            throw new IllegalArgumentException(this + " is " + ModelText.quoted(word) + ", which is not a number");
        }
    }

    /** Returns {@code value} where it may be that; otherwise says what is wanted. */
    double check(double value) {
        double least = counts() ? leastParts : LEAST_MEASURE;
        double most = counts() ? MOST_PARTS : MeshLimits.MAX_COORDINATE;
        boolean whole = !counts() || value == Math.rint(value);
        if (!(value >= least && value <= most) || !whole) {
            throw new IllegalArgumentException(this + " is " + text(value) + ", but has to be "
                    + (counts() ? "a whole number " : "") + "from " + text(least) + " to " + text(most));
        }
        return value;
    }

    private static String text(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e15
                ? String.format(Locale.ROOT, "%d", (long) value)
                : Double.toString(value);
    }
}
