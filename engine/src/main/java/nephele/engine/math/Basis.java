package nephele.engine.math;

/** A right-handed orthonormal frame of a view: it looks along −{@code back}. */
public record Basis(Vec3 right, Vec3 up, Vec3 back) {
    /** Looking along −z with y up. */
    public static final Basis WORLD = new Basis(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1));

    /** Sine of the angle below which up and back leave the right direction to rounding. */
    private static final double PARALLEL = 1e-6;

    /**
     * Looks from {@code eye} at {@code target}. Where up is parallel to that direction, zero or not a number, the axis
     * farthest from the direction takes its place; where the direction is, {@code last} stays.
     */
    public static Basis lookAt(Vec3 eye, Vec3 target, Vec3 up, Basis last) {
        Vec3 back = Directions.unit(eye.minus(target));
        if (back == null) {
            return last;
        }
        Vec3 unitUp = Directions.unit(up);
        Vec3 right = unitUp == null ? null : unitUp.cross(back);
        if (right == null || right.length() < PARALLEL) {
            right = Directions.farthestAxis(back).cross(back);
        }
        right = Directions.unit(right);
        // A short cross product is off the perpendicular by rounding; one Gram-Schmidt step mends it.
        double along = right.dot(back);
        right = Directions.unit(right.addScaled(-along, back));
        return new Basis(right, back.cross(right), back);
    }

    /**
     * @param yaw radians; 0 looks along −z, positive to the left
     * @param pitch radians, positive upwards
     */
    public static Basis ofYawPitch(double yaw, double pitch) {
        double sinYaw = StrictMath.sin(yaw);
        double cosYaw = StrictMath.cos(yaw);
        double sinPitch = StrictMath.sin(pitch);
        double cosPitch = StrictMath.cos(pitch);
        return new Basis(
                new Vec3(cosYaw, 0, -sinYaw),
                new Vec3(sinYaw * sinPitch, cosPitch, cosYaw * sinPitch),
                new Vec3(sinYaw * cosPitch, -sinPitch, cosYaw * cosPitch));
    }
}
