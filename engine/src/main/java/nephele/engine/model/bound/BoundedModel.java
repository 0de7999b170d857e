package nephele.engine.model.bound;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.model.BoundingSphere;
import nephele.engine.model.Mesh;

/** A model with all its bounds, each in the model's own coordinates. */
public record BoundedModel(String name, BoundingSphere sphere, BoxTree tree) {
    /** The level of a tree whose boxes are shown; those of single triangles would hide the model. */
    private static final int DRAWN_LEVEL = 4;

    private static final Pose WORLD = new Pose(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), Vec3.ZERO);

    private static final int SIDES = 48;

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
            case SPHERE -> addSphere(middle(at), sphere.radius(), ends);
            case BOX -> addBox(OrientedBox.of(tree.box(), at).upright(), WORLD, ends);
            case ORIENTED_BOX -> addBox(tree.box(), at, ends);
            case TREE -> {
                List<Aabb> boxes = new ArrayList<>();
                tree.addBoxes(DRAWN_LEVEL, boxes);
                boxes.forEach(box -> addBox(box, at, ends));
            }
            case TRIANGLES -> addTriangles(tree, at, ends);
        }
    }

    public Vec3 middle(Pose at) {
        return at.moved(sphere.centre());
    }

    /** Adds three great circles. */
    private static void addSphere(Vec3 centre, double radius, List<Vec3> ends) {
        for (int axis = 0; axis < 3; axis++) {
            for (int i = 0; i < SIDES; i++) {
                ends.add(centre.addScaled(radius, onCircle(axis, i)));
                ends.add(centre.addScaled(radius, onCircle(axis, i + 1)));
            }
        }
    }

    private static Vec3 onCircle(int axis, int side) {
        double angle = 2 * StrictMath.PI * side / SIDES;
        double a = StrictMath.cos(angle);
        double b = StrictMath.sin(angle);
        return axis == 0 ? new Vec3(0, a, b) : axis == 1 ? new Vec3(b, 0, a) : new Vec3(a, b, 0);
    }

    /** Adds the twelve edges of a box. */
    private static void addBox(Aabb box, Pose at, List<Vec3> ends) {
        for (int corner = 0; corner < 8; corner++) {
            for (int axis = 1; axis < 8; axis *= 2) {
                if ((corner & axis) == 0) {
                    ends.add(at.moved(box.corner(corner)));
                    ends.add(at.moved(box.corner(corner | axis)));
                }
            }
        }
    }

    /** Adds the edges of all triangles. */
    private static void addTriangles(BoxTree tree, Pose at, List<Vec3> ends) {
        List<Vec3[]> triangles = new ArrayList<>();
        tree.addTriangles(triangles);
        for (Vec3[] triangle : triangles) {
            for (int i = 0; i < 3; i++) {
                ends.add(at.moved(triangle[i]));
                ends.add(at.moved(triangle[(i + 1) % 3]));
            }
        }
    }
}
