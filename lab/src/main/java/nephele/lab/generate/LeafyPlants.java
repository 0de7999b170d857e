package nephele.lab.generate;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import nephele.lab.generate.PlantKind.Family;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Trees and bushes whose crowns are lobes of leaves on a branching structure: oak, birch, cypress, bush. */
final class LeafyPlants {
    /** The depth in a lobe at which its leaves hide a tip. */
    private static final double COVERED_DEPTH = 0.75;

    static final PlantKind BUSH = new PlantKind(Family.TREE, "bush", 1.4, LeafyPlants::bush);
    private static final int BUSH_STEMS = 9;
    private static final int BLOSSOMS = 26;
    private static final double BLOSSOM_METRES = 0.045;

    static final PlantKind CYPRESS = new PlantKind(Family.TREE, "cypress", 7, LeafyPlants::cypress);
    private static final int CYPRESS_ROWS = 9;

    static final PlantKind BIRCH = new PlantKind(Family.TREE, "birch", 11, LeafyPlants::birch);
    private static final SpaceColonisation BIRCH_GROWTH = new SpaceColonisation(0.4, 1.9, 0.75, 0.35);
    private static final double BIRCH_STEP_METRES = 0.42;
    private static final int BIRCH_STEPS = 23;

    static final PlantKind OAK = new PlantKind(Family.TREE, "oak", 9, LeafyPlants::oak);

    private static final SpaceColonisation OAK_GROWTH = new SpaceColonisation(0.45, 3.2, 0.95, 0.1);

    private LeafyPlants() {}

    /** Grows an oak: a short strong trunk, wide boughs and a broad crown of lobes. */
    private static void oak(PlantMesh mesh, PlantDice dice) {
        Clump crown = new Clump(new Vector3d(dice.around(0.3), 5.4, dice.around(0.3)), 3.7, 2.7);
        Skeleton skeleton = new Skeleton(new Vector3d(0, -0.25, 0));
        double lean = dice.around(0.12);
        int top = 0;
        for (int i = 1; i <= 6; i++) {
            top = skeleton.add(
                    new Vector3d(lean * i * 0.4 + dice.around(0.04), -0.25 + 0.4 * i, dice.around(0.05)), top);
        }
        List<Vector3d> space = new ArrayList<>();
        while (space.size() < 260) {
            Vector3d p = dice.inBall();
            if (p.y > -0.55 && p.length() > 0.3) {
                space.add(crown.at(p, 1));
            }
        }
        OAK_GROWTH.grow(skeleton, space);
        skeleton.smooth();
        List<Clump> lobes = lobesAtTips(skeleton, at -> {
            double size = dice.between(0.95, 1.25);
            return new Clump(new Vector3d(at).add(0, 0.15, 0), size, 0.78 * size);
        });
        new BranchTubes(PlantPaint.OAK_BARK, 0.035, 0).build(skeleton, skeleton.radii(0.34, 2.2), mesh, dice);
        new Foliage(PlantPaint.OAK_LEAF, crown, 0, 28, 0.74).build(lobes, mesh, dice);
    }

    /** Grows a birch: a slender white trunk through an airy crown of small hanging lobes. */
    private static void birch(PlantMesh mesh, PlantDice dice) {
        Clump crown = new Clump(new Vector3d(0, 6.6, 0), 1.9, 4.1);
        Skeleton skeleton = new Skeleton(new Vector3d(0, -0.25, 0));
        double bend = dice.between(0.2, 0.4);
        double phase = dice.between(0, 6);
        int top = 0;
        for (int i = 1; i <= BIRCH_STEPS; i++) {
            double y = -0.25 + BIRCH_STEP_METRES * i;
            double away = bend * StrictMath.sin(0.28 * y) * Math.min(1, y / 3);
            top = skeleton.add(new Vector3d(away * StrictMath.cos(phase), y, away * StrictMath.sin(phase)), top);
        }
        List<Vector3d> space = new ArrayList<>();
        while (space.size() < 170) {
            Vector3d p = dice.inBall();
            // The crown is widest below its middle.
            double narrow = p.y > -0.3 ? 1 - 0.45 * (p.y + 0.3) : 1;
            if (StrictMath.sqrt(p.x * p.x + p.z * p.z) > 0.25) {
                space.add(crown.at(p.mul(narrow, 1, narrow), 1));
            }
        }
        BIRCH_GROWTH.grow(skeleton, space);
        skeleton.smooth();
        List<Clump> lobes = lobesAtTips(skeleton, at -> {
            double size = dice.between(0.46, 0.66);
            return new Clump(new Vector3d(at).sub(0, 0.3 * size, 0), size, 1.2 * size);
        });
        new BranchTubes(PlantPaint.BIRCH_BARK, 0.016, 0.13).build(skeleton, skeleton.radii(0.15, 2.1), mesh, dice);
        new Foliage(PlantPaint.BIRCH_LEAF, crown, 0, 20, 0.46).build(lobes, mesh, dice);
    }

    /** Grows a cypress: a dark flame of upright lobes around a hidden trunk. */
    private static void cypress(PlantMesh mesh, PlantDice dice) {
        Skeleton skeleton = new Skeleton(new Vector3d(0, -0.25, 0));
        List<Clump> lobes = new ArrayList<>();
        int top = 0;
        for (int row = 0; row < CYPRESS_ROWS; row++) {
            double along = (row + 0.5) / CYPRESS_ROWS;
            double y = 0.75 + 5.2 * along;
            top = skeleton.add(new Vector3d(0, y - 0.4, 0), top);
            double wide = 0.72 * StrictMath.pow(StrictMath.sin(StrictMath.PI * (0.16 + 0.84 * along)), 0.8);
            int around = row > CYPRESS_ROWS - 2 ? 1 : row > CYPRESS_ROWS - 4 ? 3 : 5;
            for (int i = 0; i < around; i++) {
                double turn = 2 * StrictMath.PI * (i + 0.5 * row + dice.around(0.15)) / around;
                double away = around == 1 ? 0 : 0.58 * wide;
                double size = dice.between(0.26, 0.34) * (0.6 + 0.7 * wide);
                Vector3d at =
                        new Vector3d(away * StrictMath.cos(turn), y + dice.around(0.16), away * StrictMath.sin(turn));
                skeleton.add(at, top);
                lobes.add(new Clump(at, size, size * dice.between(2.3, 2.9)));
            }
        }
        lobes.add(new Clump(new Vector3d(0, 6.25, 0), 0.17, 0.75));
        Clump crown = new Clump(new Vector3d(0, 3.4, 0), 0.75, 3.4);
        new BranchTubes(PlantPaint.FIR_BARK, 0.04, 0).build(skeleton, skeleton.radii(0.14, 2.3), mesh, dice);
        new Foliage(PlantPaint.CYPRESS_LEAF, crown, 1, 9, 0.3).build(lobes, mesh, dice);
    }

    /** Grows a bush: stems that spread from the ground under round lobes, with pale blossoms. */
    private static void bush(PlantMesh mesh, PlantDice dice) {
        Skeleton skeleton = new Skeleton(new Vector3d(0, -0.1, 0));
        List<Clump> lobes = new ArrayList<>();
        for (int i = 0; i <= BUSH_STEMS; i++) {
            double turn = 2 * StrictMath.PI * (i + dice.around(0.2)) / BUSH_STEMS;
            double away = i == BUSH_STEMS ? 0 : dice.between(0.42, 0.66);
            double y = i == BUSH_STEMS ? 0.98 : 0.86 - 0.62 * away + dice.around(0.14);
            Vector3d end = new Vector3d(away * StrictMath.cos(turn), y, away * StrictMath.sin(turn));
            int middle = skeleton.add(new Vector3d(end).mul(0.6, 0.4, 0.6), 0);
            skeleton.add(end, middle);
            double size = dice.between(0.34, 0.44);
            lobes.add(new Clump(end, size, 0.86 * size));
        }
        Clump crown = new Clump(new Vector3d(0, 0.5, 0), 1.05, 0.9);
        new BranchTubes(PlantPaint.OAK_BARK, 0.005, 0).build(skeleton, skeleton.radii(0.06, 2), mesh, dice);
        new Foliage(PlantPaint.BUSH_LEAF, crown, 1, 26, 0.24).build(lobes, mesh, dice);
        Icosphere sphere = Icosphere.of(0);
        for (int i = 0; i < BLOSSOMS; i++) {
            blossom(lobes, sphere, mesh, dice);
        }
    }

    private static void blossom(List<Clump> lobes, Icosphere sphere, PlantMesh mesh, PlantDice dice) {
        Clump lobe = lobes.get((int) dice.between(0, lobes.size()));
        Vector3d direction = dice.direction();
        Vector3d at = lobe.at(direction, 1);
        if (direction.y < -0.2 || lobes.stream().anyMatch(other -> other != lobe && other.depth(at) < 1)) {
            return;
        }
        int first = -1;
        for (Vector3d corner : sphere.directions()) {
            Vector3d normal = new Vector3d(corner).add(lobe.normal(direction));
            int vertex = mesh.vertex(
                    new Vector3d(at).fma(BLOSSOM_METRES, corner), normal, PlantPaint.BLOSSOM, 0.5 + 0.5 * corner.y);
            first = first < 0 ? vertex : first;
        }
        for (int[] t : sphere.triangles()) {
            mesh.triangle(first + t[0], first + t[1], first + t[2]);
        }
    }

    /**
     * Returns lobes around tips of branches such that every tip is in one: each lobe hangs on a branch and no branch ends
     * bare.
     */
    static List<Clump> lobesAtTips(Skeleton skeleton, Function<Vector3dc, Clump> lobe) {
        List<Clump> lobes = new ArrayList<>();
        for (int tip : skeleton.tips()) {
            Vector3dc at = skeleton.point(tip);
            if (lobes.stream().allMatch(other -> other.depth(at) > COVERED_DEPTH)) {
                lobes.add(lobe.apply(at));
            }
        }
        return lobes;
    }
}
