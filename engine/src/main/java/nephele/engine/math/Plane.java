package nephele.engine.math;

/** A plane with unit normal: n · p = distance, positive side outside. */
public record Plane(double nx, double ny, double nz, double distance) {
    /**
     * Normalises, so that any non-zero normal will do; n · p = {@code distanceAlongUnitNormal} for the unit normal.
     *
     * @throws IllegalArgumentException when the normal has no direction
     */
    public static Plane of(Vec3 normal, double distanceAlongUnitNormal) {
        double largest = Math.max(Math.abs(normal.x()), Math.max(Math.abs(normal.y()), Math.abs(normal.z())));
        if (!(largest > 0) || Double.isInfinite(largest)) {
            throw new IllegalArgumentException("a plane's normal must be finite and not zero");
        }
        // Scaled by the largest component first: squares neither overflow nor vanish.
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

    public Plane opposite() {
        return new Plane(-nx, -ny, -nz, -distance);
    }

    /** Metres in front of the plane, negative behind it. */
    public double signedDistance(double x, double y, double z) {
        return nx * x + ny * y + nz * z - distance;
    }

    public double signedDistance(Vec3 p) {
        return signedDistance(p.x(), p.y(), p.z());
    }

    public Vec3 normal() {
        return new Vec3(nx, ny, nz);
    }
}
