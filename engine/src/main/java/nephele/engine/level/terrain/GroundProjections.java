package nephele.engine.level.terrain;

import nephele.engine.math.Vec3;

/**
 * The three projections in which the pictures of layers lie on a terrain: along x, from above, and along z. Each picture is
 * upright on cliffs and is not mirrored. The share of a projection is proportional to the amount by which its component
 * of the normal exceeds {@link #LEAST} (after Geiss 2007, "Generating Complex Procedural Terrains Using the GPU", GPU Gems 3):
 * up to 30° of slope there is only the picture from above, between 30° and 60° there are two or three. The shader of the
 * terrain has the same lines.
 */
public final class GroundProjections {
    /** The number of projections. */
    public static final int COUNT = 3;

    /** The projection from above; the other ones are {@code 0}, along x, and {@code 2}, along z. */
    public static final int FROM_ABOVE = 1;

    /** The component of the normal below which a projection is not seen. */
    public static final double LEAST = 0.5;

    /**
     * With rises along x and z of at most this, metres a metre, no projection but that from above is seen: the normal's x
     * is rise / √(1 + rise² + …). A little less than the tangent of 30°, for the rounding of a shader's slopes.
     */
    public static final double GENTLE_RISE = 0.999 * LEAST / Math.sqrt(1 - LEAST * LEAST);

    private final Vec3 normal;

    /** Makes the projections at a point with this smooth unit normal. */
    public GroundProjections(Vec3 normal) {
        this.normal = normal;
    }

    /** Returns the share of a projection; the sum of all three is 1. */
    public double weight(int axis) {
        double sum = excess(normal.x()) + excess(normal.y()) + excess(normal.z());
        return excess(axis == 0 ? normal.x() : axis == 1 ? normal.y() : normal.z()) / sum;
    }

    private static double excess(double component) {
        return Math.max(Math.abs(component) - LEAST, 0);
    }

    /** Returns the direction in which a picture's right lies, before it is turned into the surface. */
    public Vec3 across(int axis) {
        if (axis == 0) {
            return new Vec3(0, 0, normal.x() < 0 ? 1 : -1);
        }
        return new Vec3(axis == 2 && normal.z() < 0 ? -1 : 1, 0, 0);
    }

    /** Returns the direction in which a picture's upper side lies, before it is turned into the surface. */
    public Vec3 up(int axis) {
        return axis == FROM_ABOVE ? new Vec3(0, 0, -1) : new Vec3(0, 1, 0);
    }
}
