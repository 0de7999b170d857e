package nephele.lab.generate;

import nephele.lab.generate.PlantKind.Family;
import org.joml.Vector3d;

/** A tuft of grass: bent blades that fan out, the outer ones lower. */
final class GrassTuft {
    static final PlantKind KIND = new PlantKind(Family.TREE, "grass", 0.5, GrassTuft::grow);

    private static final int BLADES = 44;
    private static final int PARTS = 3;

    private GrassTuft() {}

    private static void grow(PlantMesh mesh, PlantDice dice) {
        for (int i = 0; i < BLADES; i++) {
            double share = StrictMath.sqrt((i + 0.5) / BLADES);
            double turn = i * 2.399963 + dice.around(0.3);
            Vector3d out = new Vector3d(StrictMath.cos(turn), 0, StrictMath.sin(turn));
            Vector3d foot = new Vector3d(out).mul(0.11 * share).sub(0, 0.03, 0);
            double length = dice.between(0.36, 0.56) * (1 - 0.25 * share);
            blade(foot, out, length, 0.25 + 0.75 * share, mesh, dice);
        }
    }

    private static void blade(Vector3d foot, Vector3d out, double length, double bend, PlantMesh mesh, PlantDice dice) {
        Vector3d beside = new Vector3d(-out.z, 0, out.x);
        Vector3d normal = new Vector3d(out).mul(0.5).add(0, 1, 0);
        double tone = dice.around(0.15);
        int left = -1;
        int right = -1;
        for (int part = 0; part <= PARTS; part++) {
            double along = (double) part / PARTS;
            double angle = 0.15 + bend * 1.15 * along;
            Vector3d middle = new Vector3d(foot)
                    .fma(length * along * StrictMath.sin(angle), out)
                    .add(0, length * along * StrictMath.cos(angle), 0);
            double half = 0.014 * (1 - 0.75 * along);
            double shade = 0.1 + 0.7 * along + tone;
            if (part == PARTS) {
                int tip = mesh.vertex(middle, normal, PlantPaint.GRASS, shade);
                mesh.leaf(left, right, tip);
            } else {
                int nextLeft = mesh.vertex(new Vector3d(middle).fma(half, beside), normal, PlantPaint.GRASS, shade);
                int nextRight = mesh.vertex(new Vector3d(middle).fma(-half, beside), normal, PlantPaint.GRASS, shade);
                if (part > 0) {
                    mesh.leaf(left, right, nextRight);
                    mesh.leaf(left, nextRight, nextLeft);
                }
                left = nextLeft;
                right = nextRight;
            }
        }
    }
}
