package nephele.lab.generate;

import java.util.ArrayList;
import java.util.List;
import nephele.lab.generate.PlantKind.Family;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Rocks: a boulder and a ledge of strata. */
final class Rocks {
    static final PlantKind LEDGE = new PlantKind(Family.ROCK, "ledge", 1.3, Rocks::ledge);
    private static final int LAYERS = 6;
    private static final int SIDES = 11;

    static final PlantKind BOULDER = new PlantKind(Family.ROCK, "boulder", 1.6, Rocks::boulder);

    private static final int CUTS = 90;
    private static final int BROAD_CUTS = 11;
    private static final Vector3dc BOULDER_SIZE = new Vector3d(1, 1.1, 0.85);
    /** Height of the ball's middle: a face that looks down would be black, since the ground reflects no light. */
    private static final double BOULDER_MIDDLE = 0.12;

    private static final double BOULDER_ROOT = 0.25;

    private Rocks() {}

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

    /**
     * Makes a boulder: many planes cut a ball; deep cuts become broad faces, shallow ones wear its edges.
     */
    private static void boulder(PlantMesh mesh, PlantDice dice) {
        List<Cut> cuts = new ArrayList<>();
        for (int i = 0; i < CUTS; i++) {
            double depth = i < BROAD_CUTS ? dice.between(0.74, 0.9) : dice.between(0.93, 1.02);
            cuts.add(new Cut(dice.direction(), depth));
        }
        cuts.add(new Cut(new Vector3d(0, -1, 0), (BOULDER_MIDDLE + BOULDER_ROOT) / BOULDER_SIZE.y()));
        for (Cut cut : cuts) {
            List<Vector3d> face = square(cut);
            for (Cut other : cuts) {
                face = other == cut ? face : clipped(face, other);
            }
            face.forEach(p -> p.mul(BOULDER_SIZE).add(0, BOULDER_MIDDLE, 0));
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

    /** Makes a rock of flat strata: tilted slabs on top of each other, each with its own outline and worn edges. */
    private static void ledge(PlantMesh mesh, PlantDice dice) {
        double[] outline = new double[SIDES];
        for (int side = 0; side < SIDES; side++) {
            outline[side] = dice.between(0.8, 1.15);
        }
        double y = -0.2;
        double driftX = 0;
        double driftZ = 0;
        for (int layer = 0; layer < LAYERS; layer++) {
            double fraction = (double) layer / (LAYERS - 1);
            double thick = dice.between(0.1, 0.42);
            double wide = 1.35 * (1 - 0.45 * fraction * fraction * fraction) * dice.between(0.76, 1.04);
            driftX += dice.between(-0.04, 0.13);
            driftZ += dice.around(0.12);
            stratum(new Vector3d(driftX, y, driftZ), wide, thick, outline, mesh, dice);
            y += 0.93 * thick;
        }
    }

    /** Makes one stratum, from its foot's middle. */
    private static void stratum(
            Vector3d foot, double wide, double thick, double[] outline, PlantMesh mesh, PlantDice dice) {
        double tone = dice.around(0.12);
        double[] fraction = {0, 0.78, 1};
        double[] inset = {0.94, 1, 0.9};
        Vector3d[][] rings = new Vector3d[3][SIDES];
        for (int side = 0; side < SIDES; side++) {
            double radius = wide * outline[side] * dice.between(0.86, 1.1);
            double turn = 2 * StrictMath.PI * (side + dice.around(0.2)) / SIDES;
            for (int ring = 0; ring < 3; ring++) {
                double away = radius * inset[ring];
                double x = away * StrictMath.cos(turn);
                double z = -0.78 * away * StrictMath.sin(turn);
                // All strata dip the same way.
                rings[ring][side] = new Vector3d(x, thick * fraction[ring] + 0.17 * x + 0.07 * z, z).add(foot);
            }
        }
        Vector3d top = middle(rings[2]);
        Vector3d bottom = middle(rings[0]);
        for (int side = 0; side < SIDES; side++) {
            int next = (side + 1) % SIDES;
            double shade = 0.3 + tone + dice.around(0.06);
            wall(rings[0][side], rings[0][next], rings[1][next], rings[1][side], mesh, shade);
            wall(rings[1][side], rings[1][next], rings[2][next], rings[2][side], mesh, shade + 0.25);
            mesh.facet(top, rings[2][side], rings[2][next], PlantPaint.LEDGE, 0.62 + tone + dice.around(0.03));
            mesh.facet(bottom, rings[0][next], rings[0][side], PlantPaint.LEDGE, 0.1);
        }
    }

    private static Vector3d middle(Vector3d[] ring) {
        Vector3d sum = new Vector3d();
        for (Vector3d corner : ring) {
            sum.fma(1.0 / ring.length, corner);
        }
        return sum;
    }

    private static void wall(Vector3d a, Vector3d b, Vector3d c, Vector3d d, PlantMesh mesh, double shade) {
        Vector3d normal = new Vector3d(c).sub(a).cross(new Vector3d(d).sub(b));
        mesh.quad(
                mesh.vertex(a, normal, PlantPaint.LEDGE, shade),
                mesh.vertex(b, normal, PlantPaint.LEDGE, shade),
                mesh.vertex(c, normal, PlantPaint.LEDGE, shade),
                mesh.vertex(d, normal, PlantPaint.LEDGE, shade));
    }
}
