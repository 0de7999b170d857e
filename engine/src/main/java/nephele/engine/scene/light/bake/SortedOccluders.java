package nephele.engine.scene.light.bake;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import nephele.engine.level.Brush;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;

/** Sorts static shapes for ray tests: convex ones and terrains as a whole, others triangle by
 * triangle. */
final class SortedOccluders implements StaticShape.Cases {
    private final List<ConvexPolyhedron> convex = new ArrayList<>();
    private final Map<Integer, Integer> itemOfModel = new TreeMap<>();
    private final List<double[]> sheets = new ArrayList<>();
    private final List<HeightField> grounds = new ArrayList<>();

    @Override
    public void convexHull(StaticShape.ConvexHull hull) {
        convex.add(hull.brush().shape());
    }

    @Override
    public void triangleMesh(StaticShape.TriangleMesh mesh) {
        PlacedModel model = mesh.model();
        Brush solid = model.solid();
        if (solid != null) {
            itemOfModel.put(model.index(), convex.size());
            convex.add(solid.shape());
        } else {
            sheets.add(model.triangles().corners());
        }
    }

    @Override
    public void heightGrid(StaticShape.HeightGrid grid) {
        grounds.add(grid.field());
    }

    /** Returns the item of each convex model, by its index in the level. */
    Map<Integer, Integer> itemOfModel() {
        return itemOfModel;
    }

    /** Returns the convex shapes, then the triangles, then terrains; appends the box of each to {@code boxes}. */
    List<Occluder> items(List<Aabb> boxes) {
        List<Occluder> items = new ArrayList<>();
        for (ConvexPolyhedron shape : convex) {
            items.add(new Occluder.Convex(shape.flatPlanes()));
            boxes.add(shape.bounds());
        }
        for (double[] corners : sheets) {
            for (int at = 0; at < corners.length; at += 9) {
                items.add(new Occluder.Triangle(corners, at));
                boxes.add(Aabb.of(List.of(corner(corners, at), corner(corners, at + 3), corner(corners, at + 6))));
            }
        }
        for (HeightField field : grounds) {
            items.add(new Occluder.Ground(field));
            boxes.add(field.bounds());
        }
        return items;
    }

    private static Vec3 corner(double[] corners, int at) {
        return new Vec3(corners[at], corners[at + 1], corners[at + 2]);
    }
}
