package nephele.app.prove;

/** A measured number of a proof, with the rule that joins the numbers of two batches. */
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

    /** The figure of both batches together. */
    public Figure joined(Figure other) {
        double joinedValue =
                switch (join) {
                    case SUM -> value + other.value;
                    case LEAST -> Math.min(value, other.value);
                    case GREATEST -> Math.max(value, other.value);
                };
        return new Figure(name, joinedValue, unit, join);
    }
}
