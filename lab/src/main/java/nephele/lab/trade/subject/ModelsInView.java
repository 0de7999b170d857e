package nephele.lab.trade.subject;

import java.util.Arrays;
import nephele.engine.model.Mesh;
import nephele.engine.scene.View;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector4d;

/**
 * Decides whether a view shows any part of a mesh: each triangle is clipped by the six planes in turn (Sutherland and
 * Hodgman, 1974).
 */
final class ModelsInView {
    private static final int MOST_CORNERS = 9;

    private final Vector4d[] corners = new Vector4d[MOST_CORNERS];
    private final Vector4d[] cut = new Vector4d[MOST_CORNERS];
    private final Matrix4d clipFromModel = new Matrix4d();

    ModelsInView() {
        Arrays.setAll(corners, i -> new Vector4d());
        Arrays.setAll(cut, i -> new Vector4d());
    }

    boolean shows(View view, Mesh mesh, Matrix4dc worldFromModel) {
        view.clipFromRelative(clipFromModel).translate(-view.eyeX(), -view.eyeY(), -view.eyeZ());
        clipFromModel.mul(worldFromModel);
        for (int at = 0; at < mesh.indices().length; at += 3) {
            for (int i = 0; i < 3; i++) {
                int p = 3 * mesh.indices()[at + i];
                corners[i].set(mesh.positions()[p], mesh.positions()[p + 1], mesh.positions()[p + 2], 1);
                clipFromModel.transform(corners[i]);
            }
            if (isLeft()) {
                return true;
            }
        }
        return false;
    }

    private boolean isLeft() {
        int count = 3;
        for (int plane = 0; plane < 6 && count > 0; plane++) {
            count = cutBy(plane, count);
        }
        return count > 0;
    }

    private int cutBy(int plane, int count) {
        int kept = 0;
        for (int i = 0; i < count; i++) {
            Vector4d from = corners[i];
            Vector4d to = corners[(i + 1) % count];
            double a = distance(from, plane);
            double b = distance(to, plane);
            if (a >= 0) {
                cut[kept++].set(from);
            }
            if (a >= 0 != b >= 0) {
                from.lerp(to, a / (a - b), cut[kept++]);
            }
        }
        for (int i = 0; i < kept; i++) {
            corners[i].set(cut[i]);
        }
        return kept;
    }

    private static double distance(Vector4d p, int plane) {
        double side = plane % 2 == 0 ? 1 : -1;
        return p.w + side * p.get(plane / 2);
    }
}
