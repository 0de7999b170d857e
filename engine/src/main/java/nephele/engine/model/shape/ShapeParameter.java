package nephele.engine.model.shape;

import nephele.engine.asset.MessageText;
import nephele.engine.model.MeshLimits;
import nephele.engine.model.ModelText;

/** A parameter of a shape, with its meaning and range. Lengths are in model units. */
public enum ShapeParameter {
    /** Edge length. */
    LENGTH(0),
    /** Radius; of a torus, that of the centre line of the tube. */
    RADIUS(0),
    /** Height. */
    HEIGHT(0),
    /** Radius of the tube. */
    TUBE(0),
    /** Divisions of an edge. */
    DIVISIONS(1),
    /** Divisions of the circle around the y axis. */
    SLICES(3),
    /** Divisions from bottom to top or around the tube. */
    STACKS(1),
    /** Divisions of each side of a patch. */
    TESSELLATION(1);

    static final int MOST_PARTS = 512;
    private static final double LEAST_MEASURE = 1e-6;

    private final int leastParts;

    /** @param leastParts minimum of a count; 0 for a length */
    ShapeParameter(int leastParts) {
        this.leastParts = leastParts;
    }

    private boolean counts() {
        return leastParts > 0;
    }

    /**
     * Parses a value.
     *
     * @throws IllegalArgumentException with a message for users that says what is expected
     */
    public double read(String word) {
        try {
            return check(Double.parseDouble(ModelText.decimal(word)));
        } catch (NumberFormatException notANumber) {
            throw new IllegalArgumentException(this + " is " + ModelText.quoted(word) + ", which is not a number");
        }
    }

    /** Returns {@code value} if it is in range; otherwise throws with a message that says what is expected. */
    double check(double value) {
        double least = counts() ? leastParts : LEAST_MEASURE;
        double most = counts() ? MOST_PARTS : MeshLimits.MAX_COORDINATE_UNITS;
        boolean whole = !counts() || value == Math.rint(value);
        if (!(value >= least && value <= most) || !whole) {
            throw new IllegalArgumentException(this + " is " + MessageText.number(value) + ", but has to be "
                    + (counts() ? "a whole number " : "") + "from " + MessageText.number(least) + " to "
                    + MessageText.number(most));
        }
        return value;
    }
}
