package nephele.lab.prove;

/**
 * A measured number of a proof, with the rule that joins the numbers of two batches.
 *
 * @param unit of the number; of a greatest or least one it may go on with where that was found
 */
public record Figure(String name, double value, String unit, Join join) {
    /** How the figures of two batches become one. */
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

    /** The figure of both batches together; what is no number stays, so that nobody takes it for a good one. */
    public Figure joined(Figure other) {
        return switch (join) {
            case SUM -> new Figure(name, value + other.value, unit, join);
            case LEAST -> other.value < value || Double.isNaN(other.value) ? other : this;
            case GREATEST -> Double.compare(other.value, value) > 0 ? other : this;
        };
    }
}
