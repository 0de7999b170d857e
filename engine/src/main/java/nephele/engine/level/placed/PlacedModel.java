package nephele.engine.level.placed;

import nephele.engine.level.Brush;
import nephele.engine.level.ModelPlacement;
import nephele.engine.math.Aabb;

/**
 * A model where the level has it.
 *
 * @param index in the level's list
 * @param solid its shape where it is convex and closed, so that it is solid all through; {@code null} for any other
 */
public record PlacedModel(int index, ModelPlacement said, WorldTriangles triangles, Aabb bounds, Brush solid) {
    static PlacedModel of(int index, ModelPlacement said, WorldTriangles triangles) {
        return new PlacedModel(index, said, triangles, triangles.bounds(), ConvexModel.solid(said, triangles));
    }

    /** Whether none of its triangles has an area, so that there is nothing to draw. */
    public boolean isEmpty() {
        return triangles.count() == 0;
    }

    PlacedModel split(double edgeMetres, int mostTriangles) {
        double wanted = Math.ceil(triangles.longestEdge() / edgeMetres);
        double possible = Math.floor(Math.sqrt((double) mostTriangles / Math.max(1, triangles.count())));
        WorldTriangles cut = SplitTriangles.of(triangles, (int) Math.min(wanted, possible));
        return new PlacedModel(index, said, cut, bounds, solid);
    }
}
