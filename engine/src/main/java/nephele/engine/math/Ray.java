package nephele.engine.math;

/**
 * A half line from an origin. The direction need not be of unit length. A ray with a direction that is zero or not
 * finite hits nothing.
 */
public final class Ray {
    /** Bound of the rounding in one slab distance, twice γ₃ (Ize 2013, "Robust BVH Ray Traversal", section 3). */
    private static final double SLAB_GROWTH = 1 + 6 * 0x1p-53;

    private double originX;
    private double originY;
    private double originZ;
    private double directionX;
    private double directionY;
    private double directionZ;
    private double inverseX;
    private double inverseY;
    private double inverseZ;
    /** The places of the bounds that the ray meets first, among the six of a box. */
    private int nearX;

    private int nearY;
    private int nearZ;
    private boolean castable;

    private Ray() {}

    /** Creates a ray from its origin in metres and its direction. */
    public Ray(
            double originX, double originY, double originZ, double directionX, double directionY, double directionZ) {
        aim(originX, originY, originZ, directionX, directionY, directionZ);
    }

    /** Returns a ray that a single owner sets again and again with {@link #aim}; it hits nothing before that. */
    public static Ray reusable() {
        return new Ray();
    }

    /** Sets the origin and direction. @return this */
    public Ray aim(
            double newOriginX,
            double newOriginY,
            double newOriginZ,
            double newDirectionX,
            double newDirectionY,
            double newDirectionZ) {
        originX = newOriginX;
        originY = newOriginY;
        originZ = newOriginZ;
        directionX = newDirectionX;
        directionY = newDirectionY;
        directionZ = newDirectionZ;
        inverseX = 1 / directionX;
        inverseY = 1 / directionY;
        inverseZ = 1 / directionZ;
        nearX = inverseX > 0 ? 0 : 3;
        nearY = inverseY > 0 ? 1 : 4;
        nearZ = inverseZ > 0 ? 2 : 5;
        double largest = Math.max(Math.abs(directionX), Math.max(Math.abs(directionY), Math.abs(directionZ)));
        castable = largest > 0 && largest <= Double.MAX_VALUE && Double.isFinite(originX + originY + originZ);
        return this;
    }

    /** Creates a ray from its origin in metres and its direction. */
    public static Ray of(Vec3 origin, Vec3 direction) {
        return new Ray(origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z());
    }

    public double originX() {
        return originX;
    }

    public double originY() {
        return originY;
    }

    public double originZ() {
        return originZ;
    }

    public double directionX() {
        return directionX;
    }

    public double directionY() {
        return directionY;
    }

    public double directionZ() {
        return directionZ;
    }

    /** Returns true if the origin is finite and the direction is finite and not zero. */
    public boolean isCastable() {
        return castable;
    }

    /** Returns origin + {@code distance} · direction. */
    public Vec3 at(double distance) {
        return new Vec3(
                originX + distance * directionX, originY + distance * directionY, originZ + distance * directionZ);
    }

    /** Intersects a box as {@link #boxEntry(double[], int, double)}. */
    public double boxEntry(Aabb box, double limit) {
        double[] bounds = {box.minX(), box.minY(), box.minZ(), box.maxX(), box.maxY(), box.maxZ()};
        return boxEntry(bounds, 0, limit);
    }

    /**
     * Intersects a box by the slab test. It never misses a box that exact arithmetic hits at a ray parameter that a
     * double can represent. A direction component of ±0, or so small that its inverse overflows, gives 0 · ∞ = NaN on a
     * face of the box, and every comparison below lets NaN pass.
     *
     * @param bounds minima and maxima, beginning at {@code at}
     * @param limit greatest ray parameter that counts
     * @return ray parameter at which the ray enters, 0 from inside, infinity for a miss
     */
    public double boxEntry(double[] bounds, int at, double limit) {
        if (!castable) {
            return Double.POSITIVE_INFINITY;
        }
        // Finite, so that an unreachable slab (+∞) is beyond it.
        double last = Math.min(limit, Double.MAX_VALUE);
        double enterX = (bounds[at + nearX] - originX) * inverseX;
        double enterY = (bounds[at + nearY] - originY) * inverseY;
        double enterZ = (bounds[at + nearZ] - originZ) * inverseZ;
        double leaveX = (bounds[at + 3 - nearX] - originX) * inverseX * SLAB_GROWTH;
        double leaveY = (bounds[at + 5 - nearY] - originY) * inverseY * SLAB_GROWTH;
        double leaveZ = (bounds[at + 7 - nearZ] - originZ) * inverseZ * SLAB_GROWTH;
        double enter = enterX > 0 ? enterX : 0;
        enter = enterY > enter ? enterY : enter;
        enter = enterZ > enter ? enterZ : enter;
        double leave = leaveX < last ? leaveX : last;
        leave = leaveY < leave ? leaveY : leave;
        leave = leaveZ < leave ? leaveZ : leave;
        return enter <= leave ? enter : Double.POSITIVE_INFINITY;
    }

    /**
     * Finds the first of some boxes that {@link #boxEntry} would not miss. One loop over the boxes is faster than a
     * call for each.
     *
     * @param limit greatest ray parameter that counts
     * @param boxes six bounds each, minima first
     * @param chosen indices of the boxes to test: those at {@code from} up to, not including, {@code to}, in this order
     * @return index in {@code chosen}, or {@code to}
     */
    public int firstBox(double limit, double[] boxes, int[] chosen, int from, int to) {
        if (!castable) {
            return to;
        }
        for (int i = from; i < to; i++) {
            if (boxEntry(boxes, 6 * chosen[i], limit) < Double.POSITIVE_INFINITY) {
                return i;
            }
        }
        return to;
    }
}
