package nephele.engine.model;

import java.util.Locale;
import nephele.engine.model.GridTriangles.Diagonal;
import org.joml.Vector3d;

/**
 * Bézier patches as triangles. Seen from outside u runs to the left and v downward in the Utah teapot, so that
 * (1 - u, 1 - v) shows a picture upright.
 *
 * @param tessellation parts of each side of a patch
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
        var mesh = new MeshBuilder(count * side * side, mostTriangles());
        CubicWeights[] weights = new CubicWeights[side];
        for (int part = 0; part < side; part++) {
            weights[part] = CubicWeights.at(part, tessellation);
        }
        for (BezierPatch patch : patches.patches()) {
            add(mesh, patch, weights);
        }
        return mesh.mesh();
    }

    @Override
    public int mostTriangles() {
        return 2 * patches.patches().size() * tessellation * tessellation;
    }

    /** The first vertex is the one at u = v = 1, which is the lower left one. */
    private void add(MeshBuilder mesh, BezierPatch patch, CubicWeights[] weights) {
        int first = mesh.nextVertex();
        var normals = new PatchNormal(patch);
        Vector3d[][] values = new Vector3d[weights.length][];
        Vector3d[][] slopes = new Vector3d[weights.length][];
        for (int column = 0; column <= tessellation; column++) {
            values[column] = patch.across(weights[column].value());
            slopes[column] = patch.across(weights[column].slope());
        }
        for (int row = tessellation; row >= 0; row--) {
            CubicWeights v = weights[row];
            for (int column = tessellation; column >= 0; column--) {
                Vector3d point = BezierPatch.along(values[column], v.value());
                Vector3d cross = BezierPatch.along(slopes[column], v.value())
                        .cross(BezierPatch.along(values[column], v.slope()));
                Vector3d normal = normals.unit(cross, column, row, tessellation);
                mesh.point(point.x, point.y, point.z)
                        .normal(normal.x, normal.y, normal.z)
                        .texture(share(tessellation - column), share(tessellation - row));
            }
        }
        GridTriangles.join(mesh, first, tessellation, tessellation, Diagonal.FALLING);
    }

    private double share(int parts) {
        return (double) parts / tessellation;
    }
}
