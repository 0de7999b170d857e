package nephele.engine.reference;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;

/** Makes the traced shapes of static shapes. */
final class TracedStatics implements StaticShape.Cases {
    private final List<TracedSolid> solids = new ArrayList<>();
    private final List<TriangleMeshShape> models = new ArrayList<>();

    private final List<GroundShape> grounds = new ArrayList<>();

    TracedStatics(StaticShapes statics) {
        statics.all().forEach(shape -> shape.select(this));
    }

    @Override
    public void convexHull(StaticShape.ConvexHull hull) {
        solids.add(new TracedSolid(hull.brush().shape()));
    }

    @Override
    public void triangleMesh(StaticShape.TriangleMesh mesh) {
        models.add(new TriangleMeshShape(mesh.model()));
    }

    @Override
    public void heightGrid(StaticShape.HeightGrid grid) {
        grounds.add(new GroundShape(grid));
    }

    List<TracedSolid> solids() {
        return solids;
    }

    List<TriangleMeshShape> models() {
        return models;
    }

    List<GroundShape> grounds() {
        return grounds;
    }
}
