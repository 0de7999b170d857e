package nephele.engine.cloud.field;

/**
 * The limit that the sides of a volume set to the bodies in it: an upright elliptic cylinder. With ρ the distance from
 * its axis, 1 at the sides, the depth is 1.3 (1 − ρ²), less what an anvil needs to end at the sides.
 *
 * @param halfX half the width of the volume, metres
 * @param spread how far outside of its body the cloud reaches, in the units of the depth
 */
record SideWalls(double halfX, double halfZ, double spread) {
    private static final double SLOPE = 1.3;

    double depth(double x, double z) {
        return depth(squared(x / halfX) + squared(z / halfZ));
    }

    private double depth(double squaredDistance) {
        return SLOPE * (1 - squaredDistance) - spread * Math.min(1, squaredDistance);
    }

    /** Returns the greatest depth in a rectangle, given by its centre and half its sides. */
    double greatest(double x, double z, double byX, double byZ) {
        double nearX = Math.max(0, Math.abs(x) - byX);
        double nearZ = Math.max(0, Math.abs(z) - byZ);
        return depth(nearX, nearZ);
    }

    private static double squared(double a) {
        return a * a;
    }
}
