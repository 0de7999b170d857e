package nephele.engine.math;

/** A ray–triangle hit, reused by its owner for every test. The barycentric weights of the corners sum to 1. */
public final class TriangleHit {
    /** γ₇ for double: the rounding of an interpolated point (Pharr, Jakob, Humphreys 2016, section 3.9.4). */
    private static final double RELATIVE_POINT_ERROR = 7 * 0x1p-53 / (1 - 7 * 0x1p-53);

    private double distance = Double.POSITIVE_INFINITY;
    private double weightA;
    private double weightB;
    private double weightC;

    /** Returns the hit at the point of a triangle with these barycentric weights, with distance 0. */
    public static TriangleHit at(double weightA, double weightB, double weightC) {
        TriangleHit hit = new TriangleHit();
        hit.set(0, weightA, weightB, weightC);
        return hit;
    }

    void set(double rayParameter, double a, double b, double c) {
        distance = rayParameter;
        weightA = a;
        weightB = b;
        weightC = c;
    }

    /** Returns the ray parameter: metres for a direction of unit length. */
    public double distance() {
        return distance;
    }

    public double weightA() {
        return weightA;
    }

    /** Interpolates the hit point from the corners, which is nearer to the plane than origin + distance · direction. */
    public Vec3 point(double[] corners, int at) {
        return new Vec3(mixed(corners, at), mixed(corners, at + 1), mixed(corners, at + 2));
    }

    private double mixed(double[] corners, int at) {
        return weightA * corners[at] + weightB * corners[at + 3] + weightC * corners[at + 6];
    }

    /**
     * Returns an origin for a ray that continues towards {@code direction} and does not hit this triangle again: the
     * hit point moved along the normal by the bound of its rounding, then to the next representable number (Pharr,
     * Jakob, Humphreys 2016, section 3.9.5). Unlike a fixed offset, this bound scales with the coordinates.
     */
    public Vec3 originTowards(Vec3 direction, double[] corners, int at) {
        Vec3 normal = WatertightRay.normal(corners, at);
        if (normal == null) {
            return point(corners, at);
        }
        double reach = Math.abs(normal.x()) * error(corners, at)
                + Math.abs(normal.y()) * error(corners, at + 1)
                + Math.abs(normal.z()) * error(corners, at + 2);
        double offset = normal.dot(direction) < 0 ? -reach : reach;
        return new Vec3(
                away(mixed(corners, at), offset * normal.x()),
                away(mixed(corners, at + 1), offset * normal.y()),
                away(mixed(corners, at + 2), offset * normal.z()));
    }

    private double error(double[] corners, int at) {
        double size = Math.abs(weightA * corners[at])
                + Math.abs(weightB * corners[at + 3])
                + Math.abs(weightC * corners[at + 6]);
        return RELATIVE_POINT_ERROR * size + Double.MIN_NORMAL;
    }

    private static double away(double value, double offset) {
        double moved = value + offset;
        return offset > 0 ? Math.nextUp(moved) : offset < 0 ? Math.nextDown(moved) : moved;
    }
}
