package nephele.lab.bound;

import nephele.engine.math.Vec3;
import nephele.engine.model.BoundingSphere;
import nephele.engine.model.Mesh;

/** A model with all its bounds, each in the model's own coordinates. */
record BoundedModel(String name, BoundingSphere sphere, BoxTree tree) {
    static BoundedModel of(String name, Mesh mesh) {
        Vec3[][] triangles = new Vec3[mesh.triangleCount()][3];
        for (int i = 0; i < mesh.indices().length; i++) {
            int at = 3 * mesh.indices()[i];
            triangles[i / 3][i % 3] =
                    new Vec3(mesh.positions()[at], mesh.positions()[at + 1], mesh.positions()[at + 2]);
        }
        return new BoundedModel(name, BoundingSphere.of(mesh), BoxTree.of(triangles));
    }

    Vec3 middle(Pose at) {
        return at.moved(sphere.centre());
    }
}
