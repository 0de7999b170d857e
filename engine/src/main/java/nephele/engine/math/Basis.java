package nephele.engine.math;

/**
 * A right-handed orthonormal view frame. The view direction is −{@code back}.
 *
 * @param right unit length
 * @param up unit length
 * @param back unit length; opposite to the view direction
 */
public record Basis(Vec3 right, Vec3 up, Vec3 back) {
    /** The frame that looks along −z with y up. */
    public static final Basis WORLD = new Basis(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1));

    /** Sine of the angle between up and back below which rounding dominates the right direction. */
    private static final double PARALLEL_SINE = 1e-6;

    /**
     * Returns the frame that looks from {@code eye} at {@code target}. If up is parallel to the view direction, zero or
     * NaN, the world axis farthest from the view direction replaces it. If the view direction is zero or not finite,
     * the result is {@code last}.
     */
    public static Basis lookAt(Vec3 eye, Vec3 target, Vec3 up, Basis last) {
        Vec3 back = Directions.unit(eye.minus(target));
        if (back == null) {
            return last;
        }
        Vec3 unitUp = Directions.unit(up);
        Vec3 right = unitUp == null ? null : unitUp.cross(back);
        if (right == null || right.length() < PARALLEL_SINE) {
            right = Directions.farthestAxis(back).cross(back);
        }
        right = Directions.unit(right);
        // Rounding moves a short cross product off the perpendicular; one Gram-Schmidt step corrects it.
        double along = right.dot(back);
        right = Directions.unit(right.addScaled(-along, back));
        return new Basis(right, back.cross(right), back);
    }

    /**
     * Returns the frame of the given view angles.
     *
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
