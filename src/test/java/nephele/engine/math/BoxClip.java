package nephele.engine.math;

import java.util.ArrayList;
import java.util.List;
import org.joml.Matrix4dc;
import org.joml.Vector4d;

/** A brute-force test whether clipping leaves any part of a box's six faces (Sutherland and Hodgman 1974). */
final class BoxClip {
    private static final int[][] FACES = {
        {0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}
    };

    private BoxClip() {}

    static boolean leavesSomething(Matrix4dc clipFromRelative, Vec3 eye, Aabb box) {
        Vector4d[] corners = new Vector4d[8];
        for (int i = 0; i < 8; i++) {
            double x = ((i & 1) == 0 ? box.minX() : box.maxX()) - eye.x();
            double y = ((i & 2) == 0 ? box.minY() : box.maxY()) - eye.y();
            double z = ((i & 4) == 0 ? box.minZ() : box.maxZ()) - eye.z();
            corners[i] = clipFromRelative.transform(new Vector4d(x, y, z, 1));
        }
        for (int[] face : FACES) {
            List<Vector4d> polygon = new ArrayList<>();
            for (int corner : face) {
                polygon.add(corners[corner]);
            }
            for (int plane = 0; plane < 6 && !polygon.isEmpty(); plane++) {
                polygon = clip(polygon, plane);
            }
            if (!polygon.isEmpty()) {
                return true;
            }
        }
        return false;
    }

    private static List<Vector4d> clip(List<Vector4d> polygon, int plane) {
        List<Vector4d> kept = new ArrayList<>();
        for (int i = 0; i < polygon.size(); i++) {
            Vector4d a = polygon.get(i);
            Vector4d b = polygon.get((i + 1) % polygon.size());
            double da = inside(a, plane);
            double db = inside(b, plane);
            if (da >= 0) {
                kept.add(a);
            }
            if (da > 0 != db > 0 && da != db) {
                kept.add(new Vector4d(a).lerp(b, da / (da - db)));
            }
        }
        return kept;
    }

    private static double inside(Vector4d p, int plane) {
        double sign = (plane & 1) == 0 ? 1 : -1;
        return p.w + sign * p.get(plane >> 1);
    }
}
