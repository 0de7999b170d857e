package nephele.scenes.xml;

import nephele.engine.math.Frustum;
import nephele.engine.math.SingularValues;
import org.joml.Matrix4dc;

/**
 * Bounding spheres under affine transforms: rotated, moved, scaled, mirrored and sheared. The caller chooses the
 * numbers; allocates nothing after construction.
 */
public final class WorldSpheres {
    private static final int STRIDE = 4;

    /** Relative error of the sums that place centre and vertices, which are rounded separately. */
    private static final double ROUNDING = 0x1p-48;

    private final double[] spheres;
    private final double rounding;

    /** Creates spheres for vertices that are drawn in double precision. */
    public WorldSpheres(int count) {
        this(count, ROUNDING);
    }

    /** @param rounding relative error of the vertices where they are drawn */
    public WorldSpheres(int count, double rounding) {
        spheres = new double[STRIDE * count];
        this.rounding = rounding;
    }

    /** Places a model's sphere. @param radius at least 0 */
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

    /** Returns false if no part can be visible, or if its pose is not finite, so that nothing is drawn. */
    public boolean maySee(int number, Frustum frustum) {
        int at = STRIDE * number;
        double sum = spheres[at] + spheres[at + 1] + spheres[at + 2] + spheres[at + 3];
        return Double.isFinite(sum)
                && frustum.mayIntersect(spheres[at], spheres[at + 1], spheres[at + 2], spheres[at + 3]);
    }
}
