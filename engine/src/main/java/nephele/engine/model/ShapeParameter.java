package nephele.engine.model;

/** A number that describes a shape: what it means and what it may be. */
public enum ShapeParameter {
    /** Of a side, in units. */
    LENGTH(0),
    /** In units; of a torus, to the middle of the tube. */
    RADIUS(0),
    /** In units. */
    HEIGHT(0),
    /** Radius of the tube, in units. */
    TUBE(0),
    /** Parts of a side. */
    DIVISIONS(1),
    /** Parts of the circle around the y axis. */
    SLICES(3),
    /** Parts from bottom to top or around the tube. */
    STACKS(1),
    /** Parts of each side of a patch. */
    TESSELLATION(1);

    static final int MOST_PARTS = 512;
    private static final double LEAST_MEASURE = 1e-6;

    private final int leastParts;

    /** @param leastParts 0 for what is measured instead of counted */
    ShapeParameter(int leastParts) {
        this.leastParts = leastParts;
    }

    private boolean counts() {
        return leastParts > 0;
    }

    /** @throws IllegalArgumentException with what is wanted instead, for users */
    public double read(String word) {
        try {
            return check(Double.parseDouble(ModelText.decimal(word)));
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
            throw new IllegalArgumentException(
                    this + " is " + ShownNumber.of(value) + ", but has to be " + (counts() ? "a whole number " : "")
                            + "from " + ShownNumber.of(least) + " to " + ShownNumber.of(most));
        }
        return value;
    }
}
