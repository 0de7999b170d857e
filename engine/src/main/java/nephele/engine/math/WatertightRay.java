package nephele.engine.math;

/**
 * A ray prepared for the watertight triangle test of Woop, Benthin and Wald 2013, "Watertight Ray/Triangle
 * Intersection", JCGT 2(1), in double. Both triangles at an edge compute the same products with opposite sign, and a
 * rounded difference of products never has the wrong sign; zero counts as inside for both. So no ray passes between
 * them. The paper's fallback to higher precision, which decides which of the two is hit, is omitted.
 */
public final class WatertightRay {
    /** γₙ for double. */
    private static final double GAMMA_2 = 2 * 0x1p-53 / (1 - 2 * 0x1p-53);

    private static final double GAMMA_3 = 3 * 0x1p-53 / (1 - 3 * 0x1p-53);
    private static final double GAMMA_5 = 5 * 0x1p-53 / (1 - 5 * 0x1p-53);

    private final double[] origin;
    private final int axisX;
    private final int axisY;
    private final int axisZ;
    private final double shearX;
    private final double shearY;
    private final double shearZ;
    private final boolean castable;

    /** Prepares a ray; one that is not castable misses every triangle. */
    public WatertightRay(Ray ray) {
        origin = new double[] {ray.originX(), ray.originY(), ray.originZ()};
        double[] direction = {ray.directionX(), ray.directionY(), ray.directionZ()};
        int largest = Math.abs(direction[0]) > Math.abs(direction[1]) ? 0 : 1;
        axisZ = Math.abs(direction[2]) > Math.abs(direction[largest]) ? 2 : largest;
        axisX = (axisZ + 1) % 3;
        axisY = (axisZ + 2) % 3;
        shearX = direction[axisX] / direction[axisZ];
        shearY = direction[axisY] / direction[axisZ];
        shearZ = 1 / direction[axisZ];
        castable = ray.isCastable() && Math.abs(shearZ) <= Double.MAX_VALUE;
    }

    /**
     * Intersects the ray with a triangle from either side and stores the hit in {@code hit}. A triangle is missed if it
     * has no area, is parallel to the ray, or is nearer than the rounding of the distance.
     *
     * @param corners nine numbers, beginning at {@code at}
     * @param limit greatest ray parameter that counts
     * @return true if the ray hits
     */
    public boolean intersects(double[] corners, int at, double limit, TriangleHit hit) {
        double az = corners[at + axisZ] - origin[axisZ];
        double bz = corners[at + 3 + axisZ] - origin[axisZ];
        double cz = corners[at + 6 + axisZ] - origin[axisZ];
        double ax = corners[at + axisX] - origin[axisX] - shearX * az;
        double ay = corners[at + axisY] - origin[axisY] - shearY * az;
        double bx = corners[at + 3 + axisX] - origin[axisX] - shearX * bz;
        double by = corners[at + 3 + axisY] - origin[axisY] - shearY * bz;
        double cx = corners[at + 6 + axisX] - origin[axisX] - shearX * cz;
        double cy = corners[at + 6 + axisY] - origin[axisY] - shearY * cz;
        double u = cx * by - cy * bx;
        double v = ax * cy - ay * cx;
        double w = bx * ay - by * ax;
        double determinant = u + v + w;
        boolean mixedSigns = (u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0);
        if (!castable || mixedSigns || !(Math.abs(determinant) > 0)) {
            return false;
        }
        double inverse = 1 / determinant;
        double distance = (u * az + v * bz + w * cz) * shearZ * inverse;
        double uncertainty =
                uncertainty(max(az, bz, cz), max(ax, bx, cx), max(ay, by, cy), max(u, v, w)) * Math.abs(inverse);
        if (!(distance > uncertainty && distance <= limit)) {
            return false;
        }
        hit.set(distance, u * inverse, v * inverse, w * inverse);
        return true;
    }

    /** Returns the rounding bound of the scaled distance (Pharr, Jakob, Humphreys 2016, section 3.9.6). */
    private double uncertainty(double maxZ, double maxX, double maxY, double maxE) {
        double deltaZ = GAMMA_3 * maxZ;
        double deltaX = GAMMA_5 * (maxX + maxZ * Math.abs(shearX));
        double deltaY = GAMMA_5 * (maxY + maxZ * Math.abs(shearY));
        double deltaE = 2 * (GAMMA_2 * maxX * maxY + deltaY * maxX + deltaX * maxY);
        return 3 * (GAMMA_3 * maxE * maxZ + deltaE * maxZ + deltaZ * maxE) * Math.abs(shearZ);
    }

    private static double max(double a, double b, double c) {
        return Math.max(Math.abs(a), Math.max(Math.abs(b), Math.abs(c)));
    }

    /** Returns the unit normal, counter-clockwise seen from its tip; {@code null} for a triangle without area. */
    public static Vec3 normal(double[] corners, int at) {
        double abX = corners[at + 3] - corners[at];
        double abY = corners[at + 4] - corners[at + 1];
        double abZ = corners[at + 5] - corners[at + 2];
        double acX = corners[at + 6] - corners[at];
        double acY = corners[at + 7] - corners[at + 1];
        double acZ = corners[at + 8] - corners[at + 2];
        return Directions.unit(abY * acZ - abZ * acY, abZ * acX - abX * acZ, abX * acY - abY * acX);
    }
}
