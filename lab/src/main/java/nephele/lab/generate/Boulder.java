package nephele.lab.generate;

import java.util.ArrayList;
import java.util.List;
import nephele.lab.generate.PlantKind.Family;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** A boulder: what many planes leave of a ball; deep cuts become broad faces, shallow ones wear their edges. */
final class Boulder {
    static final PlantKind KIND = new PlantKind(Family.ROCK, "boulder", 1.6, Boulder::grow);

    private static final int CUTS = 90;
    private static final int BROAD_CUTS = 11;
    private static final Vector3dc SIZE = new Vector3d(1, 1.1, 0.85);
    /** Height of the ball's middle: a face that looks down would be black, since the ground reflects no light. */
    private static final double MIDDLE = 0.12;

    private static final double ROOT = 0.25;

    private Boulder() {}

    /**
     * A plane: the rock is where normal · p ≤ distance.
     *
     * @param normal of unit length
     */
    private record Cut(Vector3dc normal, double distance) {
        double above(Vector3dc point) {
            return normal.dot(point) - distance;
        }
    }

    private static void grow(PlantMesh mesh, PlantDice dice) {
        List<Cut> cuts = new ArrayList<>();
        for (int i = 0; i < CUTS; i++) {
            double depth = i < BROAD_CUTS ? dice.between(0.74, 0.9) : dice.between(0.93, 1.02);
            cuts.add(new Cut(dice.direction(), depth));
        }
        cuts.add(new Cut(new Vector3d(0, -1, 0), (MIDDLE + ROOT) / SIZE.y()));
        for (Cut cut : cuts) {
            List<Vector3d> face = square(cut);
            for (Cut other : cuts) {
                face = other == cut ? face : clipped(face, other);
            }
            face.forEach(p -> p.mul(SIZE).add(0, MIDDLE, 0));
            double shade = 0.4 + 0.26 * cut.normal.y() + dice.around(0.08);
            for (int i = 2; i < face.size(); i++) {
                mesh.facet(face.get(0), face.get(i - 1), face.get(i), PlantPaint.BOULDER, shade);
            }
        }
    }

    /** Returns a large square in the plane, counter-clockwise seen from outside. */
    private static List<Vector3d> square(Cut cut) {
        Vector3d n = new Vector3d(cut.normal);
        Vector3d across = Math.abs(n.y) < 0.9 ? new Vector3d(0, 1, 0) : new Vector3d(1, 0, 0);
        across.cross(n).normalize(4);
        Vector3d up = new Vector3d(n).cross(across);
        List<Vector3d> corners = new ArrayList<>();
        for (int[] sign : new int[][] {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
            corners.add(new Vector3d(n).mul(cut.distance).fma(sign[0], across).fma(sign[1], up));
        }
        return corners;
    }

    /** Returns the part of a convex polygon below a plane (Sutherland and Hodgman 1974). */
    private static List<Vector3d> clipped(List<Vector3d> polygon, Cut cut) {
        List<Vector3d> kept = new ArrayList<>();
        for (int i = 0; i < polygon.size(); i++) {
            Vector3d from = polygon.get(i);
            Vector3d to = polygon.get((i + 1) % polygon.size());
            double a = cut.above(from);
            double b = cut.above(to);
            if (a <= 0) {
                kept.add(from);
            }
            if (a < 0 && b > 0 || a > 0 && b < 0) {
                kept.add(new Vector3d(from).lerp(to, a / (a - b)));
            }
        }
        return kept;
    }
}
