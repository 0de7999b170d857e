package nephele.workshop.prove.proof;

/**
 * A measured number of a proof, with the rule that joins the numbers of two batches.
 *
 * @param unit of the number; for a greatest or least number it may include where that number was found
 */
public record Figure(String name, double value, String unit, Join join) {
    /** The rule that joins the figures of two batches. */
    public enum Join {
        SUM,
        LEAST,
        GREATEST
    }

    public static Figure sum(String name, double value, String unit) {
        return new Figure(name, value, unit, Join.SUM);
    }

    public static Figure greatest(String name, double value, String unit) {
        return new Figure(name, value, unit, Join.GREATEST);
    }

    public static Figure least(String name, double value, String unit) {
        return new Figure(name, value, unit, Join.LEAST);
    }

    /** Returns the figure of both batches together. NaN persists, so that an invalid number does not appear valid. */
    public Figure joined(Figure other) {
        return switch (join) {
            case SUM -> new Figure(name, value + other.value, unit, join);
            case LEAST -> other.value < value || Double.isNaN(other.value) ? other : this;
            case GREATEST -> Double.compare(other.value, value) > 0 ? other : this;
        };
    }
}
