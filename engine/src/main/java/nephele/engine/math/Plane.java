package nephele.engine.math;

/**
 * A plane with a unit normal: n · p = distance. The normal points outwards, to positive distances.
 *
 * @param distance signed distance from the origin in metres
 */
public record Plane(double nx, double ny, double nz, double distance) {
    /**
     * Returns the plane with the normalised normal n, so that n · p = {@code distanceAlongUnitNormal}.
     *
     * @throws IllegalArgumentException if the normal is zero or not finite
     */
    public static Plane of(Vec3 normal, double distanceAlongUnitNormal) {
        double largest = Math.max(Math.abs(normal.x()), Math.max(Math.abs(normal.y()), Math.abs(normal.z())));
        if (!(largest > 0) || Double.isInfinite(largest)) {
            throw new IllegalArgumentException("a plane's normal must be finite and not zero");
        }
        // Scales by the largest component first, so that squares neither overflow nor underflow.
        double x = normal.x() / largest;
        double y = normal.y() / largest;
        double z = normal.z() / largest;
        double length = Math.sqrt(x * x + y * y + z * z);
        return new Plane(x / length, y / length, z / length, distanceAlongUnitNormal);
    }

    /** Returns the plane through a point with this unit normal. */
    public static Plane through(Vec3 unitNormal, Vec3 point) {
        return new Plane(unitNormal.x(), unitNormal.y(), unitNormal.z(), unitNormal.dot(point));
    }

    /** Returns the same plane with the opposite normal. */
    public Plane opposite() {
        return new Plane(-nx, -ny, -nz, -distance);
    }

    /** Returns the signed distance in metres, positive in front of the plane. */
    public double signedDistance(double x, double y, double z) {
        return nx * x + ny * y + nz * z - distance;
    }

    /** Returns the signed distance in metres, positive in front of the plane. */
    public double signedDistance(Vec3 p) {
        return signedDistance(p.x(), p.y(), p.z());
    }

    /** Returns the least signed distance of a box's points. */
    public double leastDistance(Aabb box) {
        return signedDistance(
                nx > 0 ? box.minX() : box.maxX(), ny > 0 ? box.minY() : box.maxY(), nz > 0 ? box.minZ() : box.maxZ());
    }

    /** Returns the greatest signed distance of a box's points. */
    public double greatestDistance(Aabb box) {
        return signedDistance(
                nx > 0 ? box.maxX() : box.minX(), ny > 0 ? box.maxY() : box.minY(), nz > 0 ? box.maxZ() : box.minZ());
    }

    /** Returns the point of the plane that is nearest to another point. */
    public Vec3 nearest(Vec3 p) {
        return p.addScaled(-signedDistance(p), normal());
    }

    /** Returns the unit normal. */
    public Vec3 normal() {
        return new Vec3(nx, ny, nz);
    }
}
