package nephele.engine.collision;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Kept;

/**
 * Sorts static shapes by how they are solid: convex through and through, triangle by triangle, or as ground. Colliders of
 * shapes that are in a world already are used again.
 */
final class StaticColliders implements StaticShape.Cases {
    private final List<Collider> convex = new ArrayList<>();
    private final List<Collider> sheets = new ArrayList<>();
    private final List<StaticShape.HeightGrid> ground = new ArrayList<>();
    private final CollisionWorld world;
    private final int solidsBefore;
    /** Where each solid and each model was in its list, {@link Kept#NEW} where it was not. */
    private final int[] placeOfSolid;

    private final int[] placeOfModel;
    /** Of each model before: its first item in the world. */
    private final int[] itemOfModel;

    private StaticColliders(StaticShapes shapes, StaticShapes before, CollisionWorld world) {
        this.world = world;
        solidsBefore = before.solids().size();
        placeOfSolid = Kept.places(before.solids(), shapes.solids());
        placeOfModel = Kept.places(triangles(before), triangles(shapes));
        itemOfModel = itemOfModel(before);
        shapes.all().forEach(shape -> shape.select(this));
    }

    private static List<WorldTriangles> triangles(StaticShapes shapes) {
        return shapes.models().all().stream().map(PlacedModel::triangles).toList();
    }

    private static int[] itemOfModel(StaticShapes shapes) {
        List<PlacedModel> models = shapes.models().all();
        int[] items = new int[models.size()];
        int convexItem = shapes.solids().size();
        int sheetItem = convexItem + shapes.models().solids().size();
        for (int i = 0; i < items.length; i++) {
            boolean isConvex = models.get(i).solid() != null;
            items[i] = isConvex ? convexItem++ : sheetItem;
            sheetItem += isConvex ? 0 : models.get(i).triangles().count();
        }
        return items;
    }

    static StaticColliders of(StaticShapes shapes) {
        return new StaticColliders(shapes, StaticShapes.of(List.of()), null);
    }

    /** @param world of the shapes before */
    static StaticColliders edited(StaticShapes shapes, StaticShapes before, CollisionWorld world) {
        return new StaticColliders(shapes, before, world);
    }

    @Override
    public void convexHull(StaticShape.ConvexHull hull) {
        int index = hull.index();
        // A solid that was painted otherwise is another brush of the same shape, at the same place.
        int place = placeOfSolid[index] == Kept.NEW && index < solidsBefore ? index : placeOfSolid[index];
        convex.add(place == Kept.NEW ? collider(hull.brush()) : same(place, hull.brush()));
    }

    @Override
    public void triangleMesh(StaticShape.TriangleMesh mesh) {
        PlacedModel model = mesh.model();
        int place = placeOfModel[model.index()];
        if (model.solid() != null) {
            convex.add(place == Kept.NEW ? collider(model.solid()) : same(itemOfModel[place], model.solid()));
        } else if (place == Kept.NEW) {
            sheets.addAll(ThinSheet.of(model.said().id(), model.triangles()));
        } else {
            for (int i = 0; i < model.triangles().count(); i++) {
                sheets.add(world.collider(itemOfModel[place] + i));
            }
        }
    }

    @Override
    public void heightGrid(StaticShape.HeightGrid grid) {
        ground.add(grid);
    }

    private static Collider collider(Brush brush) {
        return new Collider(brush.solidId(), brush.shape());
    }

    /** The world's collider where it is that of a brush. */
    private Collider same(int item, Brush brush) {
        Collider known = world.collider(item);
        return known.solidId().equals(brush.solidId()) && known.shape().equals(brush.shape()) ? known : collider(brush);
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
