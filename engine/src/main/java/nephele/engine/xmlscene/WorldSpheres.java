package nephele.engine.xmlscene;

import nephele.engine.math.Frustum;
import nephele.engine.math.SingularValues;
import org.joml.Matrix4dc;

/**
 * Spheres that follow what they are around exactly: turned, moved, scaled, mirrored and sheared. Numbered as who places
 * them likes; allocates nothing after it is built.
 */
public final class WorldSpheres {
    private static final int STRIDE = 4;

    /** Of the sums that place centre and vertices, which round apart. */
    private static final double ROUNDING = 0x1p-48;

    private final double[] spheres;
    private final double rounding;

    public WorldSpheres(int count) {
        this(count, ROUNDING);
    }

    /** @param rounding how far off, relative to the numbers that enter, vertices may be where they are drawn */
    public WorldSpheres(int count, double rounding) {
        spheres = new double[STRIDE * count];
        this.rounding = rounding;
    }

    /** A sphere as a model has it, at its place. @param radius at least 0 */
    public void place(int number, double x, double y, double z, double radius, Matrix4dc m) {
        double stretch = SingularValues.maximum(m);
        int at = STRIDE * number;
        spheres[at] = m.m00() * x + m.m10() * y + m.m20() * z + m.m30();
        spheres[at + 1] = m.m01() * x + m.m11() * y + m.m21() * z + m.m31();
        spheres[at + 2] = m.m02() * x + m.m12() * y + m.m22() * z + m.m32();
        double reach = stretch * (Math.abs(x) + Math.abs(y) + Math.abs(z) + radius);
        double sums = reach + Math.abs(m.m30()) + Math.abs(m.m31()) + Math.abs(m.m32());
        spheres[at + 3] = radius * stretch + rounding * sums;
    }

    public double x(int number) {
        return spheres[STRIDE * number];
    }

    public double y(int number) {
        return spheres[STRIDE * number + 1];
    }

    public double z(int number) {
        return spheres[STRIDE * number + 2];
    }

    public double radius(int number) {
        return spheres[STRIDE * number + 3];
    }

    /** False when no part of it can be visible, or when its place is not finite: then there is nothing to draw. */
    public boolean maySee(int number, Frustum frustum) {
        int at = STRIDE * number;
        double sum = spheres[at] + spheres[at + 1] + spheres[at + 2] + spheres[at + 3];
        return Double.isFinite(sum)
                && frustum.mayIntersect(spheres[at], spheres[at + 1], spheres[at + 2], spheres[at + 3]);
    }
}
