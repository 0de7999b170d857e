package nephele.engine.collision;

/**
 * Signed distance between two rounded shapes, with the direction that increases it. When their cores overlap, the depth
 * is unknown: the result is then minus the sum of the radii, along the line between the centres. Reused for every
 * query.
 */
public final class HullDistance {
    private final Gjk gjk = new Gjk();
    private double metres;
    private double normalX;
    private double normalY;
    private double normalZ;

    /** Returns the signed distance, outside overlapping cores never more than the true one. */
    public double metres() {
        return metres;
    }

    /** Returns a component of the unit vector from the second shape towards the first. */
    public double normalX() {
        return normalX;
    }

    public double normalY() {
        return normalY;
    }

    public double normalZ() {
        return normalZ;
    }

    /**
     * Measures the distance.
     *
     * @param x coordinate of the first shape's origin relative to the second's; likewise y and z
     */
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
