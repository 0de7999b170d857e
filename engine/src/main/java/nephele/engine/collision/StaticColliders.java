package nephele.engine.collision;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShape;

/** Sorts static shapes by how they are solid: convex through and through, triangle by triangle, or as ground. */
final class StaticColliders implements StaticShape.Cases {
    private final List<Collider> convex = new ArrayList<>();
    private final List<Collider> sheets = new ArrayList<>();
    private final List<StaticShape.HeightGrid> ground = new ArrayList<>();

    @Override
    public void convexHull(StaticShape.ConvexHull hull) {
        addConvex(hull.brush());
    }

    @Override
    public void triangleMesh(StaticShape.TriangleMesh mesh) {
        PlacedModel model = mesh.model();
        if (model.solid() != null) {
            addConvex(model.solid());
        } else {
            sheets.addAll(ThinSheet.of(model.said().id(), model.triangles()));
        }
    }

    @Override
    public void heightGrid(StaticShape.HeightGrid grid) {
        ground.add(grid);
    }

    private void addConvex(Brush brush) {
        convex.add(new Collider(brush.solidId(), brush.shape()));
    }

    /** The convex ones, then the sheets. */
    List<Collider> listed() {
        List<Collider> all = new ArrayList<>(convex);
        all.addAll(sheets);
        return all;
    }

    List<StaticShape.HeightGrid> ground() {
        return ground;
    }
}
