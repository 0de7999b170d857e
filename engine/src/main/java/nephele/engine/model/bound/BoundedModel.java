package nephele.engine.model.bound;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.model.BoundingSphere;
import nephele.engine.model.Mesh;

/** A model with all its bounds, each in the model's own coordinates. */
public record BoundedModel(String name, BoundingSphere sphere, BoxTree tree) {
    public static BoundedModel of(String name, Mesh mesh) {
        Vec3[][] triangles = new Vec3[mesh.triangleCount()][3];
        for (int i = 0; i < mesh.indices().length; i++) {
            int at = 3 * mesh.indices()[i];
            triangles[i / 3][i % 3] =
                    new Vec3(mesh.positions()[at], mesh.positions()[at + 1], mesh.positions()[at + 2]);
        }
        return new BoundedModel(name, BoundingSphere.of(mesh), BoxTree.of(triangles));
    }

    /** @param triangles three corners each, at least one triangle */
    public static BoundedModel of(String name, Vec3[][] triangles) {
        float[] corners = new float[9 * triangles.length];
        for (int i = 0; i < 3 * triangles.length; i++) {
            Vec3 corner = triangles[i / 3][i % 3];
            corners[3 * i] = (float) corner.x();
            corners[3 * i + 1] = (float) corner.y();
            corners[3 * i + 2] = (float) corner.z();
        }
        return new BoundedModel(name, BoundingSphere.of(corners), BoxTree.of(triangles));
    }

    /** Adds the lines that show a volume: pairs of points in the world. */
    public void outline(Bound bound, Pose at, List<Vec3> ends) {
        switch (bound) {
            case SPHERE -> BoundOutline.sphere(middle(at), sphere.radius(), ends);
            case AXIS_ALIGNED_BOX ->
                BoundOutline.box(OrientedBox.of(tree.box(), at).upright(), BoundOutline.WORLD, ends);
            case ORIENTED_BOX -> BoundOutline.box(tree.box(), at, ends);
            case HIERARCHY -> {
                List<Aabb> boxes = new ArrayList<>();
                tree.addBoxes(BoundOutline.SHOWN_LEVEL, boxes);
                boxes.forEach(box -> BoundOutline.box(box, at, ends));
            }
            case TRIANGLES -> BoundOutline.triangles(tree, at, ends);
        }
    }

    public Vec3 middle(Pose at) {
        return at.moved(sphere.centre());
    }
}
