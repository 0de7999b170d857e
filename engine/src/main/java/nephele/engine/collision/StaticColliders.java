package nephele.engine.collision;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.IdentityDiff;

/**
 * Sorts static shapes by their kind of collider: convex, a sheet for each triangle, or ground. Colliders of shapes that
 * are already in a world are reused.
 */
final class StaticColliders {
    private final List<Collider> convex = new ArrayList<>();
    private final List<Collider> sheets = new ArrayList<>();
    private final List<StaticShape.HeightGrid> ground = new ArrayList<>();
    private final CollisionWorld world;
    private final int solidsBefore;
    /** The place that each solid and each model had in the list before, {@link IdentityDiff#NEW} for new ones. */
    private final int[] placeOfSolid;

    private final int[] placeOfModel;
    /** The first item in the world of each model before. */
    private final int[] itemOfModel;

    private StaticColliders(StaticShapes shapes, StaticShapes before, CollisionWorld world) {
        this.world = world;
        solidsBefore = before.solids().size();
        placeOfSolid = IdentityDiff.previousIndices(before.solids(), shapes.solids());
        placeOfModel = IdentityDiff.previousIndices(triangles(before), triangles(shapes));
        itemOfModel = itemOfModel(before);
        shapes.forEach(this::addHull, this::addMesh, ground::add);
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

    /** @param world built from the shapes before */
    static StaticColliders edited(StaticShapes shapes, StaticShapes before, CollisionWorld world) {
        return new StaticColliders(shapes, before, world);
    }

    private void addHull(StaticShape.ConvexHull hull) {
        int index = hull.index();
        // A solid with a changed surface is another brush of the same shape, at the same place.
        int place = placeOfSolid[index] == IdentityDiff.NEW && index < solidsBefore ? index : placeOfSolid[index];
        convex.add(place == IdentityDiff.NEW ? collider(hull.brush()) : same(place, hull.brush()));
    }

    private void addMesh(StaticShape.TriangleMesh mesh) {
        PlacedModel model = mesh.model();
        int place = placeOfModel[model.index()];
        if (model.solid() != null) {
            convex.add(place == IdentityDiff.NEW ? collider(model.solid()) : same(itemOfModel[place], model.solid()));
        } else if (place == IdentityDiff.NEW) {
            sheets.addAll(Collider.triangles(model.authored().id(), model.triangles()));
        } else {
            for (int i = 0; i < model.triangles().count(); i++) {
                sheets.add(world.collider(itemOfModel[place] + i));
            }
        }
    }

    private static Collider collider(Brush brush) {
        return new Collider(brush.solidId(), brush.shape());
    }

    /** Returns the world's collider if it is that of the brush, a new one otherwise. */
    private Collider same(int item, Brush brush) {
        Collider known = world.collider(item);
        return known.solidId().equals(brush.solidId()) && known.shape().equals(brush.shape()) ? known : collider(brush);
    }

    /** Returns the convex colliders, then the sheets. */
    List<Collider> listed() {
        List<Collider> all = new ArrayList<>(convex);
        all.addAll(sheets);
        return all;
    }

    List<StaticShape.HeightGrid> ground() {
        return ground;
    }
}
