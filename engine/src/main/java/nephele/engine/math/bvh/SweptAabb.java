package nephele.engine.math.bvh;

import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** An axis-aligned box in linear motion. */
public record SweptAabb(Aabb box, Vec3 motion, Aabb whole) implements BoxTest {
    /** Bound of the rounding in one slab distance and the sums before it. */
    private static final double GROWTH = 1 + 8 * 0x1p-53;

    public static SweptAabb of(Aabb box, Vec3 motion) {
        Aabb whole = new Aabb(
                box.minX() + Math.min(0, motion.x()),
                box.minY() + Math.min(0, motion.y()),
                box.minZ() + Math.min(0, motion.z()),
                box.maxX() + Math.max(0, motion.x()),
                box.maxY() + Math.max(0, motion.y()),
                box.maxZ() + Math.max(0, motion.z()));
        return new SweptAabb(box, motion, whole);
    }

    /**
     * Returns true if the moving box touches a box: slab test against the box grown by the moving one (their Minkowski
     * sum). Errors are conservative: it may report a near miss.
     */
    @Override
    public boolean passes(double[] bounds, int at) {
        if (!(bounds[at] <= whole.maxX()
                && whole.minX() <= bounds[at + 3]
                && bounds[at + 1] <= whole.maxY()
                && whole.minY() <= bounds[at + 4]
                && bounds[at + 2] <= whole.maxZ()
                && whole.minZ() <= bounds[at + 5])) {
            return false;
        }
        double enterX = enter(bounds[at] - box.maxX(), bounds[at + 3] - box.minX(), motion.x());
        double enterY = enter(bounds[at + 1] - box.maxY(), bounds[at + 4] - box.minY(), motion.y());
        double enterZ = enter(bounds[at + 2] - box.maxZ(), bounds[at + 5] - box.minZ(), motion.z());
        double leaveX = leave(bounds[at] - box.maxX(), bounds[at + 3] - box.minX(), motion.x());
        double leaveY = leave(bounds[at + 1] - box.maxY(), bounds[at + 4] - box.minY(), motion.y());
        double leaveZ = leave(bounds[at + 2] - box.maxZ(), bounds[at + 5] - box.minZ(), motion.z());
        double enter = Math.max(enterX, Math.max(enterY, enterZ));
        double leave = Math.min(leaveX, Math.min(leaveY, leaveZ));
        return !(enter > leave * GROWTH);
    }

    /**
     * Returns the entry time; without motion along an axis the overlap test has decided and the axis bounds nothing.
     */
    private static double enter(double low, double high, double speed) {
        return speed == 0 ? 0 : Math.max(0, (speed > 0 ? low : high) / speed);
    }

    private static double leave(double low, double high, double speed) {
        return speed == 0 ? 1 : Math.min(1, (speed > 0 ? high : low) / speed);
    }
}
