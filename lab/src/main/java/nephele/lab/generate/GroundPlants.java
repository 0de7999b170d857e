package nephele.lab.generate;

import nephele.lab.generate.PlantKind.Family;
import org.joml.Vector3d;

/** Plants without wood: fern and grass. */
final class GroundPlants {
    static final PlantKind GRASS = new PlantKind(Family.TREE, "grass", 0.5, GroundPlants::grass);
    private static final int BLADES = 44;
    private static final int BLADE_PARTS = 3;

    static final PlantKind FERN = new PlantKind(Family.TREE, "fern", 0.7, GroundPlants::fern);

    private static final int FRONDS = 11;
    private static final int LEAFLETS = 11;

    private GroundPlants() {}

    /** Grows a fern: arching fronds with leaflets on both sides, from one crown at the ground. */
    private static void fern(PlantMesh mesh, PlantDice dice) {
        for (int i = 0; i < FRONDS; i++) {
            double turn = 2 * StrictMath.PI * (i + dice.around(0.25)) / FRONDS;
            double length = dice.between(0.8, 1.05);
            double rise = i % 3 == 0 ? 1.25 : dice.between(0.8, 1.1);
            frond(new Frond(turn, length, rise), mesh, dice);
        }
    }

    private record Frond(double turn, double length, double rise) {
        /** Returns a point of the frond: along it from 0 to 1, and beside it in metres. */
        Vector3d at(double along, double beside) {
            double away = 0.03 + length * 0.5 * along;
            double y = length * rise * (1.6 * along - 1.25 * along * along) - 0.02 - 0.25 * Math.abs(beside);
            double x = StrictMath.cos(turn);
            double z = StrictMath.sin(turn);
            return new Vector3d(away * x - beside * z, y, away * z + beside * x);
        }
    }

    private static void frond(Frond frond, PlantMesh mesh, PlantDice dice) {
        double tone = dice.around(0.12);
        Vector3d normal = new Vector3d(0.45 * StrictMath.cos(frond.turn), 1, 0.45 * StrictMath.sin(frond.turn));
        for (int i = 0; i < LEAFLETS; i++) {
            double from = 0.14 + 0.8 * i / LEAFLETS;
            double to = from + 0.8 / LEAFLETS;
            double reach = 0.2 * StrictMath.sin(StrictMath.PI * StrictMath.pow(1 - from, 0.75)) * frond.length;
            double shade = 0.25 + 0.5 * from + tone;
            int near = mesh.vertex(frond.at(from, 0), normal, PlantPaint.FERN, shade - 0.15);
            int far = mesh.vertex(frond.at(to, 0), normal, PlantPaint.FERN, shade - 0.1);
            for (double side : new double[] {1, -1}) {
                Vector3d end = frond.at(from + 0.09, side * reach * dice.between(0.9, 1.1));
                mesh.leaf(near, mesh.vertex(end, normal, PlantPaint.FERN, shade + 0.2), far);
            }
        }
        double half = 0.008;
        int left = mesh.vertex(frond.at(0, half), normal, PlantPaint.FERN, 0.1);
        int right = mesh.vertex(frond.at(0, -half), normal, PlantPaint.FERN, 0.1);
        for (double along : new double[] {0.25, 0.6, 1}) {
            int nextLeft = mesh.vertex(frond.at(along, half * (1.1 - along)), normal, PlantPaint.FERN, 0.2);
            int nextRight = mesh.vertex(frond.at(along, -half * (1.1 - along)), normal, PlantPaint.FERN, 0.2);
            mesh.leaf(left, right, nextRight);
            mesh.leaf(left, nextRight, nextLeft);
            left = nextLeft;
            right = nextRight;
        }
    }

    /** Grows a tuft of grass: bent blades that fan out, the outer ones lower. */
    private static void grass(PlantMesh mesh, PlantDice dice) {
        for (int i = 0; i < BLADES; i++) {
            double outward = StrictMath.sqrt((i + 0.5) / BLADES);
            double turn = i * 2.399963 + dice.around(0.3);
            Vector3d out = new Vector3d(StrictMath.cos(turn), 0, StrictMath.sin(turn));
            Vector3d foot = new Vector3d(out).mul(0.11 * outward).sub(0, 0.03, 0);
            double length = dice.between(0.36, 0.56) * (1 - 0.25 * outward);
            blade(foot, out, length, 0.25 + 0.75 * outward, mesh, dice);
        }
    }

    private static void blade(Vector3d foot, Vector3d out, double length, double bend, PlantMesh mesh, PlantDice dice) {
        Vector3d beside = new Vector3d(-out.z, 0, out.x);
        Vector3d normal = new Vector3d(out).mul(0.5).add(0, 1, 0);
        double tone = dice.around(0.15);
        int left = -1;
        int right = -1;
        for (int part = 0; part <= BLADE_PARTS; part++) {
            double along = (double) part / BLADE_PARTS;
            double angle = 0.15 + bend * 1.15 * along;
            Vector3d middle = new Vector3d(foot)
                    .fma(length * along * StrictMath.sin(angle), out)
                    .add(0, length * along * StrictMath.cos(angle), 0);
            double half = 0.014 * (1 - 0.75 * along);
            double shade = 0.1 + 0.7 * along + tone;
            if (part == BLADE_PARTS) {
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
