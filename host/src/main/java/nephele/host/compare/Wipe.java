package nephele.host.compare;

/**
 * The line between two pictures of the same view: the left one is seen left of it.
 *
 * @param fraction of the width that the left picture has, 0 to 1; what lies outside is clamped, and no number is the middle
 */
public record Wipe(double fraction) {
    public static final Wipe MIDDLE = new Wipe(0.5);

    public Wipe {
        fraction = Double.isNaN(fraction) ? 0.5 : Math.max(0, Math.min(1, fraction));
    }

    /** Returns the wipe moved to the right by a fraction of the width, to the left by a negative one. */
    public Wipe moved(double by) {
        return new Wipe(fraction + by);
    }

    /** Returns the number of columns that the left picture has, which is the index of the first one of the right picture. */
    public int column(int width) {
        return (int) Math.round(fraction * width);
    }
}
