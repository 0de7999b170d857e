package nephele.editor.terrain;

/** The places of a stroke's dabs: its beginning, then at equal distances along its way. */
final class Dabs {
    private final double spacing;
    private double x;
    private double z;
    /** The way from the last dab to the present place. */
    private double since;

    /** A dab at a place. */
    @FunctionalInterface
    interface Dab {
        void at(double x, double z);
    }

    /** @param spacing metres between two dabs along the way */
    Dabs(double spacing, double x, double z) {
        this.spacing = spacing;
        this.x = x;
        this.z = z;
    }

    /** Goes straight to a place. */
    void to(double toX, double toZ, Dab dab) {
        double way = Math.hypot(toX - x, toZ - z);
        double next = spacing - since;
        for (; next <= way; next += spacing) {
            double share = next / way;
            dab.at(x + share * (toX - x), z + share * (toZ - z));
        }
        since = way - (next - spacing);
        x = toX;
        z = toZ;
    }
}
