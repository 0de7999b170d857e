package nephele.lab.generate;

import nephele.lab.generate.PlantKind.Family;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** A fir: whorls of hanging boughs around a straight trunk, shorter towards the top. */
final class FirTree {
    static final PlantKind KIND = new PlantKind(Family.TREE, "fir", 12, FirTree::grow);

    private static final int WHORLS = 14;
    private static final double LOWEST_METRES = 1.3;
    private static final double TOP_METRES = 11.6;

    /** Places along a bough where its edge is, as fractions of its length. */
    private static final double[] ALONG = {0, 0.3, 0.42, 0.68, 0.76, 1};

    /** Half width of a bough there, as a fraction of its length: twigs make its edge jagged. */
    private static final double[] WIDE = {0.05, 0.25, 0.15, 0.2, 0.09, 0};

    private FirTree() {}

    private static void grow(PlantMesh mesh, PlantDice dice) {
        Skeleton skeleton = new Skeleton(new Vector3d(0, -0.25, 0));
        int top = 0;
        for (int i = 1; i <= 12; i++) {
            top = skeleton.add(new Vector3d(0, -0.25 + i * 0.98, 0), top);
        }
        double[] radii = new double[skeleton.size()];
        for (int i = 0; i < radii.length; i++) {
            radii[i] = 0.24 * (1 - 0.95 * i / (radii.length - 1));
        }
        new BranchTubes(PlantPaint.FIR_BARK, 0.01, 0).build(skeleton, radii, mesh, dice);
        for (int whorl = 0; whorl < WHORLS; whorl++) {
            double fraction = StrictMath.pow((double) whorl / (WHORLS - 1), 0.92);
            double length = 2.55 * StrictMath.pow(1 - fraction, 0.85) + 0.28;
            int boughs = fraction > 0.8 ? 5 : fraction > 0.5 ? 7 : 9;
            double turned = dice.between(0, 6);
            for (int i = 0; i < boughs; i++) {
                double turn = turned + 2 * StrictMath.PI * (i + dice.around(0.18)) / boughs;
                double y = LOWEST_METRES + (TOP_METRES - LOWEST_METRES) * fraction + dice.around(0.12);
                bough(new Bough(y, turn, length * dice.between(0.8, 1.12), fraction), mesh, dice);
            }
        }
        Vector3d tip = new Vector3d(0, 12, 0);
        Icosphere sphere = Icosphere.of(0);
        Clump leader = new Clump(new Vector3d(0, 11.5, 0), 0.1, 0.55);
        int[] vertices = sphere.directions().stream()
                .mapToInt(d -> mesh.vertex(leader.at(d, 1), d, PlantPaint.FIR_NEEDLE, 0.8))
                .toArray();
        for (int[] t : sphere.triangles()) {
            mesh.triangle(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
        }
    }

    /**
     * A bough.
     *
     * @param fraction 0 for the lowest, 1 for the highest
     */
    private record Bough(double y, double turn, double length, double fraction) {
        /** Returns a point: along the bough, beside it and below its spine, as fractions of its length. */
        Vector3d at(double along, double beside, double below) {
            // Boughs rise at the top of the tree and hang at its foot; their ends turn up.
            double slope = 0.35 - 0.95 * (1 - fraction) * along + 0.55 * along * along * along - 0.25;
            double flat = length * along * 0.95;
            double x = StrictMath.cos(turn);
            double z = StrictMath.sin(turn);
            double side = beside * length;
            return new Vector3d(flat * x - side * z, y + length * (along * slope - below), flat * z + side * x);
        }
    }

    private static void bough(Bough bough, PlantMesh mesh, PlantDice dice) {
        double tone = dice.around(0.1) + 0.12 * bough.fraction;
        int[] spine = new int[ALONG.length];
        int[][] edges = new int[2][ALONG.length];
        for (int i = 0; i < ALONG.length; i++) {
            double along = ALONG[i];
            Vector3d middle = bough.at(along, 0, 0);
            Vector3d out = outward(middle, bough);
            spine[i] = mesh.vertex(middle, out, PlantPaint.FIR_NEEDLE, 0.24 + 0.42 * along + tone);
            for (int side = 0; side < 2; side++) {
                double beside = (side == 0 ? WIDE[i] : -WIDE[i]) * dice.between(0.8, 1.2);
                Vector3d edge = bough.at(along, beside, 0.35 * Math.abs(beside) + 0.03);
                Vector3d normal = new Vector3d(edge).sub(middle).mul(1.2).add(out);
                double shade = 0.12 + 0.6 * along + tone + dice.around(0.08);
                edges[side][i] = mesh.vertex(edge, normal, PlantPaint.FIR_NEEDLE, shade);
            }
        }
        for (int i = 0; i + 1 < ALONG.length; i++) {
            mesh.quad(spine[i], spine[i + 1], edges[1][i + 1], edges[1][i]);
            mesh.quad(spine[i + 1], spine[i], edges[0][i], edges[0][i + 1]);
            mesh.quad(edges[0][i], edges[1][i], edges[1][i + 1], edges[0][i + 1]);
        }
    }

    /** Returns the direction away from the trunk and upward that gives whorls their soft light. */
    private static Vector3d outward(Vector3dc point, Bough bough) {
        return new Vector3d(point.x(), 0.75 * bough.length, point.z()).normalize();
    }
}
