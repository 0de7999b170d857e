package nephele.engine.model.bound;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** The lines by which bounding volumes are shown, as pairs of points. */
final class BoundOutline {
    /** The level of a tree whose boxes are shown; those of single triangles would hide the model. */
    static final int SHOWN_LEVEL = 4;

    static final Pose WORLD = new Pose(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), Vec3.ZERO);

    private static final int SIDES = 48;

    private BoundOutline() {}

    /** Adds three great circles. */
    static void sphere(Vec3 centre, double radius, List<Vec3> ends) {
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
    static void box(Aabb box, Pose at, List<Vec3> ends) {
        for (int corner = 0; corner < 8; corner++) {
            for (int axis = 1; axis < 8; axis *= 2) {
                if ((corner & axis) == 0) {
                    ends.add(at.moved(corner(box, corner)));
                    ends.add(at.moved(corner(box, corner | axis)));
                }
            }
        }
    }

    private static Vec3 corner(Aabb box, int corner) {
        return new Vec3(
                (corner & 1) == 0 ? box.minX() : box.maxX(),
                (corner & 2) == 0 ? box.minY() : box.maxY(),
                (corner & 4) == 0 ? box.minZ() : box.maxZ());
    }

    /** Adds the edges of all triangles. */
    static void triangles(BoxTree tree, Pose at, List<Vec3> ends) {
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
