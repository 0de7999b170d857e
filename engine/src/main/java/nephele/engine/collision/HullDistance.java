package nephele.engine.collision;

/**
 * Signed distance between two rounded shapes, with the direction that increases it. While their cores overlap, only that
 * they do is known: they are told to overlap by both radii, and to part along the line of their centres. Reused.
 */
public final class HullDistance {
    private final Gjk gjk = new Gjk();
    private double metres;
    private double normalX;
    private double normalY;
    private double normalZ;

    /** Never more than the truth. */
    public double metres() {
        return metres;
    }

    /** Unit length, from the second shape towards the first. */
    public double normalX() {
        return normalX;
    }

    public double normalY() {
        return normalY;
    }

    public double normalZ() {
        return normalZ;
    }

    /** @param x of the first shape's origin relative to the second's; y and z alike */
    public void measure(RoundedHull first, double x, double y, double z, RoundedHull second) {
        gjk.measure(first, x, y, z, second);
        double radii = first.radiusMetres() + second.radiusMetres();
        if (gjk.distance() > 0) {
            metres = gjk.distance() - radii;
            normalX = gjk.normalX();
            normalY = gjk.normalY();
            normalZ = gjk.normalZ();
            return;
        }
        double length = Math.sqrt(x * x + y * y + z * z);
        metres = -radii;
        normalX = length > 0 ? x / length : 0;
        normalY = length > 0 ? y / length : 1;
        normalZ = length > 0 ? z / length : 0;
    }
}
