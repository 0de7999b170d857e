package nephele.engine.level.placed;

import nephele.engine.level.Brush;
import nephele.engine.level.ModelPlacement;
import nephele.engine.math.Aabb;
import nephele.engine.model.Mesh;
import org.joml.Matrix4dc;

/**
 * A model at its place in the level.
 *
 * @param index index in the level's list
 * @param triangles none of a model that is planted over a field
 * @param mesh the content of its file
 * @param solid its shape if it is convex and closed, so that its interior is solid; {@code null} for others
 */
public record PlacedModel(
        int index,
        ModelPlacement authored,
        Mesh mesh,
        Matrix4dc worldFromModel,
        WorldTriangles triangles,
        Aabb bounds,
        Brush solid) {
    static PlacedModel of(int index, ModelPlacement authored, Mesh mesh, Matrix4dc worldFromModel) {
        WorldTriangles triangles = authored.isPlanted() ? WorldTriangles.NONE : WorldTriangles.of(mesh, worldFromModel);
        Brush solid = ConvexModel.solid(authored, triangles);
        return new PlacedModel(index, authored, mesh, worldFromModel, triangles, triangles.bounds(), solid);
    }

    /** Returns this model with another index. */
    PlacedModel at(int otherIndex) {
        return index == otherIndex ? this : with(otherIndex, triangles);
    }

    private PlacedModel with(int otherIndex, WorldTriangles others) {
        return new PlacedModel(otherIndex, authored, mesh, worldFromModel, others, bounds, solid);
    }

    /** Returns true if none of its triangles has an area, so that there is nothing to draw. */
    public boolean isEmpty() {
        return triangles.count() == 0;
    }

    PlacedModel split(double edgeMetres, int mostTriangles) {
        double wanted = Math.ceil(triangles.longestEdge() / edgeMetres);
        double possible = Math.floor(Math.sqrt((double) mostTriangles / Math.max(1, triangles.count())));
        return with(index, WorldTriangles.TriangleSubdivision.of(triangles, (int) Math.min(wanted, possible)));
    }
}
