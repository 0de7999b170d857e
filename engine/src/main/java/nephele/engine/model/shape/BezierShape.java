package nephele.engine.model.shape;

import java.util.Locale;
import nephele.engine.model.Mesh;
import nephele.engine.model.MeshLimits;
import org.joml.Vector3d;

/**
 * A tessellated surface of Bézier patches. Seen from outside, u runs to the left and v downwards in the Utah teapot, so
 * the texture coordinates (1 - u, 1 - v) show an image upright.
 *
 * @param patches the surface
 * @param tessellation divisions of each side of a patch
 */
public record BezierShape(BezierPatches patches, int tessellation) implements Shape {
    public BezierShape {
        ShapeParameter.TESSELLATION.check(tessellation);
        long triangles = 2L * tessellation * tessellation * patches.patches().size();
        if (triangles > MeshLimits.MAX_TRIANGLES) {
            throw new IllegalArgumentException(String.format(
                    Locale.ROOT,
                    "TESSELLATION is %d, which makes %d triangles of %d patches; at most %d are taken",
                    tessellation,
                    triangles,
                    patches.patches().size(),
                    MeshLimits.MAX_TRIANGLES));
        }
    }

    @Override
    public Mesh mesh() {
        int count = patches.patches().size();
        int side = tessellation + 1;
        var mesh = new MeshBuilder(count * side * side, maxTriangles());
        BernsteinWeights[] weights = new BernsteinWeights[side];
        for (int part = 0; part < side; part++) {
            weights[part] = BernsteinWeights.at(part, tessellation);
        }
        for (BezierPatch patch : patches.patches()) {
            add(mesh, patch, weights);
        }
        return mesh.mesh();
    }

    @Override
    public int maxTriangles() {
        return 2 * patches.patches().size() * tessellation * tessellation;
    }

    /** Adds a patch; the first vertex, the lower left one, is at u = v = 1. */
    private void add(MeshBuilder mesh, BezierPatch patch, BernsteinWeights[] weights) {
        int first = mesh.nextVertex();
        var normals = new PatchNormal(patch);
        Vector3d[][] values = new Vector3d[weights.length][];
        Vector3d[][] slopes = new Vector3d[weights.length][];
        for (int column = 0; column <= tessellation; column++) {
            values[column] = patch.across(weights[column].value());
            slopes[column] = patch.across(weights[column].slope());
        }
        for (int row = tessellation; row >= 0; row--) {
            BernsteinWeights v = weights[row];
            for (int column = tessellation; column >= 0; column--) {
                Vector3d point = BezierPatch.along(values[column], v.value());
                Vector3d cross = BezierPatch.along(slopes[column], v.value())
                        .cross(BezierPatch.along(values[column], v.slope()));
                Vector3d normal = normals.unit(cross, column, row, tessellation);
                mesh.point(point.x, point.y, point.z)
                        .normal(normal.x, normal.y, normal.z)
                        .texture(fraction(tessellation - column), fraction(tessellation - row));
            }
        }
        mesh.grid(first, tessellation, tessellation);
    }

    private double fraction(int parts) {
        return (double) parts / tessellation;
    }

    /**
     * Computes outward unit normals of a patch: the cross product of its derivatives, or its limit where they vanish or
     * are parallel, as at the tip of the Utah teapot, where a whole edge of a patch is one point.
     */
    private static final class PatchNormal {
        /** Relative to the square of the patch's size, because a cross product scales with it. */
        private static final double VANISHING = 1e-12;

        private static final double[] STEPS_INWARD = {1e-4, 1e-3, 1e-2, 1e-1};

        private final BezierPatch patch;
        private final double vanishing;

        PatchNormal(BezierPatch patch) {
            this.patch = patch;
            this.vanishing = VANISHING * squaredSize(patch);
        }

        /** @param cross the cross product of the derivatives; may be modified */
        Vector3d unit(Vector3d cross, int column, int row, int parts) {
            if (cross.length() > vanishing) {
                return cross.normalize();
            }
            BernsteinWeights u = BernsteinWeights.at(column, parts);
            BernsteinWeights v = BernsteinWeights.at(row, parts);
            Vector3d normal = secondOrder(u, v, column == parts ? -1 : 1, row == parts ? -1 : 1);
            return normal.length() > vanishing
                    ? normal.normalize()
                    : inward((double) column / parts, (double) row / parts);
        }

        private Vector3d cross(BernsteinWeights u, BernsteinWeights v) {
            return patch.weighted(u.slope(), v.value()).cross(patch.weighted(u.value(), v.slope()));
        }

        /**
         * Returns the limit of the normal at an edge that is one point. A step s into the patch, the derivative that is
         * 0 at the edge is s times the mixed derivative, which therefore replaces it; from the far edge the step is
         * negative.
         */
        private Vector3d secondOrder(BernsteinWeights u, BernsteinWeights v, int intoColumns, int intoRows) {
            Vector3d alongU = patch.weighted(u.slope(), v.value());
            Vector3d alongV = patch.weighted(u.value(), v.slope());
            Vector3d mixed = patch.weighted(u.slope(), v.slope());
            return alongU.length() < alongV.length()
                    ? mixed.mul(intoRows).cross(alongV)
                    : alongU.cross(mixed.mul(intoColumns));
        }

        /** Returns the normal a small step towards the middle; +y if the patch is a line or a point. */
        private Vector3d inward(double u, double v) {
            for (double step : STEPS_INWARD) {
                Vector3d normal =
                        cross(BernsteinWeights.at(u + step * (0.5 - u)), BernsteinWeights.at(v + step * (0.5 - v)));
                if (normal.length() > vanishing) {
                    return normal.normalize();
                }
            }
            return new Vector3d(0, 1, 0);
        }

        private static double squaredSize(BezierPatch patch) {
            double most = 0;
            for (Vector3d point : patch.points()) {
                most = Math.max(most, point.distanceSquared(patch.points()[0]));
            }
            return most;
        }
    }

    /**
     * The cubic Bernstein polynomials at one parameter.
     *
     * @param value values of the four polynomials
     * @param slope their first derivatives
     */
    private record BernsteinWeights(double[] value, double[] slope) {
        /**
         * Evaluates at {@code part / parts} in integers up to the last division, so that mirrored parameters match bitwise.
         */
        static BernsteinWeights at(int part, int parts) {
            long t = part;
            long rest = parts - part;
            double cube = (double) parts * parts * parts;
            return new BernsteinWeights(
                    new double[] {
                        rest * rest * rest / cube, 3 * t * rest * rest / cube, 3 * t * t * rest / cube, t * t * t / cube
                    },
                    slopes((double) part / parts));
        }

        static BernsteinWeights at(double t) {
            double rest = 1 - t;
            return new BernsteinWeights(
                    new double[] {rest * rest * rest, 3 * t * rest * rest, 3 * t * t * rest, t * t * t}, slopes(t));
        }

        private static double[] slopes(double t) {
            double rest = 1 - t;
            return new double[] {-3 * rest * rest, 3 * rest * rest - 6 * t * rest, 6 * t * rest - 3 * t * t, 3 * t * t};
        }
    }
}
