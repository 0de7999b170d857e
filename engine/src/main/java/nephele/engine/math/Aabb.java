package nephele.engine.math;

/** An axis-aligned box in metres. It is empty if a minimum exceeds its maximum. */
public record Aabb(double minX, double minY, double minZ, double maxX, double maxY, double maxZ) {
    public static final Aabb EMPTY = new Aabb(
            Double.POSITIVE_INFINITY,
            Double.POSITIVE_INFINITY,
            Double.POSITIVE_INFINITY,
            Double.NEGATIVE_INFINITY,
            Double.NEGATIVE_INFINITY,
            Double.NEGATIVE_INFINITY);

    /** Returns the box with the given centre and edge lengths. */
    public static Aabb around(Vec3 centre, Vec3 size) {
        return new Aabb(
                centre.x() - size.x() / 2,
                centre.y() - size.y() / 2,
                centre.z() - size.z() / 2,
                centre.x() + size.x() / 2,
                centre.y() + size.y() / 2,
                centre.z() + size.z() / 2);
    }

    /** Returns the smallest box that contains all points; {@link #EMPTY} for none. */
    public static Aabb of(Iterable<Vec3> points) {
        Aabb box = EMPTY;
        for (Vec3 p : points) {
            box = box.union(new Aabb(p.x(), p.y(), p.z(), p.x(), p.y(), p.z()));
        }
        return box;
    }

    public boolean isEmpty() {
        return !(minX <= maxX && minY <= maxY && minZ <= maxZ);
    }

    /** Returns the smallest box that contains both; an empty box adds nothing if it is {@link #EMPTY}. */
    public Aabb union(Aabb b) {
        return new Aabb(
                Math.min(minX, b.minX),
                Math.min(minY, b.minY),
                Math.min(minZ, b.minZ),
                Math.max(maxX, b.maxX),
                Math.max(maxY, b.maxY),
                Math.max(maxZ, b.maxZ));
    }

    /** Returns the box translated by {@code by}. */
    public Aabb moved(Vec3 by) {
        return new Aabb(minX + by.x(), minY + by.y(), minZ + by.z(), maxX + by.x(), maxY + by.y(), maxZ + by.z());
    }

    /** Returns the box with every face moved outwards; a negative distance shrinks it. */
    public Aabb grown(double metres) {
        return new Aabb(minX - metres, minY - metres, minZ - metres, maxX + metres, maxY + metres, maxZ + metres);
    }

    /** Returns true if the point is in the box or on a face; false for NaN. */
    public boolean contains(double x, double y, double z) {
        return x >= minX && x <= maxX && y >= minY && y <= maxY && z >= minZ && z <= maxZ;
    }

    /** Returns the distance of the nearest point of the box; 0 within it. */
    public double nearest(Vec3 place) {
        return nearest(place.x(), place.y(), place.z());
    }

    /** Returns the distance of the nearest point of the box; 0 within it. */
    public double nearest(double x, double y, double z) {
        double dx = Math.max(0, Math.max(minX - x, x - maxX));
        double dy = Math.max(0, Math.max(minY - y, y - maxY));
        double dz = Math.max(0, Math.max(minZ - z, z - maxZ));
        return Math.sqrt(dx * dx + dy * dy + dz * dz);
    }

    /** Returns a corner by the bits of its index, 0 to 7: 1 for the greater x, 2 for the greater y, 4 for the greater z. */
    public Vec3 corner(int index) {
        return new Vec3((index & 1) == 0 ? minX : maxX, (index & 2) == 0 ? minY : maxY, (index & 4) == 0 ? minZ : maxZ);
    }

    /** Returns the least coordinate on an axis, 0 to 2 for x to z. */
    public double least(int axis) {
        return axis == 0 ? minX : axis == 1 ? minY : minZ;
    }

    /** Returns the greatest coordinate on an axis, 0 to 2 for x to z. */
    public double greatest(int axis) {
        return axis == 0 ? maxX : axis == 1 ? maxY : maxZ;
    }

    /** Returns the distance of the farthest corner. */
    public double farthest(double x, double y, double z) {
        double dx = Math.max(maxX - x, x - minX);
        double dy = Math.max(maxY - y, y - minY);
        double dz = Math.max(maxZ - z, z - minZ);
        return Math.sqrt(dx * dx + dy * dy + dz * dz);
    }

    /** Returns true if the boxes overlap or touch; false if one is empty. */
    public boolean overlaps(Aabb b) {
        return minX <= b.maxX && b.minX <= maxX && minY <= b.maxY && b.minY <= maxY && minZ <= b.maxZ && b.minZ <= maxZ;
    }

    /** Returns true if it overlaps or touches the box in {@code bounds} at {@code at}: three minima, three maxima. */
    public boolean overlaps(double[] bounds, int at) {
        return bounds[at] <= maxX
                && minX <= bounds[at + 3]
                && bounds[at + 1] <= maxY
                && minY <= bounds[at + 4]
                && bounds[at + 2] <= maxZ
                && minZ <= bounds[at + 5];
    }

    /** Returns true if a face is infinitely far away. */
    public boolean isUnbounded() {
        return Double.isInfinite(minX)
                || Double.isInfinite(minY)
                || Double.isInfinite(minZ)
                || Double.isInfinite(maxX)
                || Double.isInfinite(maxY)
                || Double.isInfinite(maxZ);
    }

    /** Returns true if one of the six numbers from {@code at} on is infinite: three minima, three maxima. */
    public static boolean isUnbounded(double[] bounds, int at) {
        for (int i = at; i < at + 6; i++) {
            if (Double.isInfinite(bounds[i])) {
                return true;
            }
        }
        return false;
    }

    public Vec3 centre() {
        return new Vec3((minX + maxX) / 2, (minY + maxY) / 2, (minZ + maxZ) / 2);
    }
}
