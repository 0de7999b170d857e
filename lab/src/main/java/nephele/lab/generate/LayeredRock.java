package nephele.lab.generate;

import nephele.lab.generate.PlantKind.Family;
import org.joml.Vector3d;

/** A rock of flat strata: tilted slabs on top of each other, each with its own outline and worn edges. */
final class LayeredRock {
    static final PlantKind KIND = new PlantKind(Family.ROCK, "ledge", 1.3, LayeredRock::grow);

    private static final int LAYERS = 6;
    private static final int SIDES = 11;

    private LayeredRock() {}

    private static void grow(PlantMesh mesh, PlantDice dice) {
        double[] outline = new double[SIDES];
        for (int side = 0; side < SIDES; side++) {
            outline[side] = dice.between(0.8, 1.15);
        }
        double y = -0.2;
        double driftX = 0;
        double driftZ = 0;
        for (int layer = 0; layer < LAYERS; layer++) {
            double share = (double) layer / (LAYERS - 1);
            double thick = dice.between(0.1, 0.42);
            double wide = 1.35 * (1 - 0.45 * share * share * share) * dice.between(0.76, 1.04);
            driftX += dice.between(-0.04, 0.13);
            driftZ += dice.around(0.12);
            Slab slab = new Slab(new Vector3d(driftX, y, driftZ), wide, thick, dice.around(0.12));
            slab.build(outline, mesh, dice);
            y += 0.93 * thick;
        }
    }

    /** One stratum, from its foot's middle. */
    private record Slab(Vector3d foot, double wide, double thick, double tone) {
        void build(double[] outline, PlantMesh mesh, PlantDice dice) {
            double[] share = {0, 0.78, 1};
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
                    rings[ring][side] = new Vector3d(x, thick * share[ring] + 0.17 * x + 0.07 * z, z).add(foot);
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
}
