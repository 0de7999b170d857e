package nephele.engine.level.placed;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Vec3;
import nephele.engine.model.bound.Bound;
import nephele.engine.model.bound.BoundedModel;
import nephele.engine.model.bound.Pose;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.joml.Vector4d;

/** The bounding volumes of a level's models in the world; immutable. Models without triangles have none. */
public final class ModelBounds {
    private record Placed(BoundedModel model, Pose at) {}

    private final List<Placed> all = new ArrayList<>();

    private ModelBounds() {}

    /** Makes the bounds of all models. Oriented boxes are turned with the model, also if it is sheared. */
    public static ModelBounds of(PlacedModels models) {
        var bounds = new ModelBounds();
        for (PlacedModel model : models.all()) {
            if (!model.isEmpty()) {
                Pose at = pose(model.worldFromModel());
                bounds.all.add(
                        new Placed(BoundedModel.of(model.authored().id(), triangles(model.triangles(), at)), at));
            }
        }
        return bounds;
    }

    /** Returns the pose with the directions of the model's axes; made perpendicular from the first on (Gram–Schmidt). */
    private static Pose pose(Matrix4dc worldFromModel) {
        Vector3d x = worldFromModel.getColumn(0, new Vector4d()).xyz(new Vector3d());
        Vector3d y = worldFromModel.getColumn(1, new Vector4d()).xyz(new Vector3d());
        x.normalize();
        y.fma(-y.dot(x), x).normalize();
        Vec3 at = Vec3.of(worldFromModel.getTranslation(new Vector3d()));
        return x.isFinite() && y.isFinite()
                ? new Pose(Vec3.of(x), Vec3.of(y), Vec3.of(x).cross(Vec3.of(y)), at)
                : new Pose(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), at);
    }

    private static Vec3[][] triangles(WorldTriangles world, Pose at) {
        Vec3[][] triangles = new Vec3[world.count()][3];
        for (int i = 0; i < 3 * triangles.length; i++) {
            int from = 3 * world.vertices()[i];
            triangles[i / 3][i % 3] = at.local(
                    new Vec3(world.positions()[from], world.positions()[from + 1], world.positions()[from + 2]));
        }
        return triangles;
    }

    /** Returns whether a ball has a point in common with the volume of a model. */
    public boolean touch(Bound bound, Vec3 centre, double radiusMetres) {
        for (Placed placed : all) {
            if (bound.touches(placed.model, placed.at, centre, radiusMetres)) {
                return true;
            }
        }
        return false;
    }

    /** Returns the lines that show the volumes: pairs of points in the world. */
    public List<Vec3> outlines(Bound bound) {
        List<Vec3> ends = new ArrayList<>();
        all.forEach(placed -> placed.model.outline(bound, placed.at, ends));
        return ends;
    }
}
