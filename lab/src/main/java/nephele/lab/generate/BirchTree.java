package nephele.lab.generate;

import java.util.ArrayList;
import java.util.List;
import nephele.lab.generate.PlantKind.Family;
import org.joml.Vector3d;

/** A birch: a slender white trunk through an airy crown of small hanging lobes. */
final class BirchTree {
    static final PlantKind KIND = new PlantKind(Family.TREE, "birch", 11, BirchTree::grow);

    private static final SpaceColonisation GROWTH = new SpaceColonisation(0.4, 1.9, 0.75, 0.35);
    private static final double TRUNK_STEP_METRES = 0.42;
    private static final int TRUNK_STEPS = 23;

    private BirchTree() {}

    private static void grow(PlantMesh mesh, PlantDice dice) {
        Clump crown = new Clump(new Vector3d(0, 6.6, 0), 1.9, 4.1);
        Skeleton skeleton = new Skeleton(new Vector3d(0, -0.25, 0));
        double bend = dice.between(0.2, 0.4);
        double phase = dice.between(0, 6);
        int top = 0;
        for (int i = 1; i <= TRUNK_STEPS; i++) {
            double y = -0.25 + TRUNK_STEP_METRES * i;
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
        GROWTH.grow(skeleton, space);
        skeleton.smooth();
        List<Clump> lobes = Lobes.atTips(skeleton, at -> {
            double size = dice.between(0.46, 0.66);
            return new Clump(new Vector3d(at).sub(0, 0.3 * size, 0), size, 1.2 * size);
        });
        new BranchTubes(PlantPaint.BIRCH_BARK, 0.016, 0.13).build(skeleton, skeleton.radii(0.15, 2.1), mesh, dice);
        new Foliage(PlantPaint.BIRCH_LEAF, crown, 0, 20, 0.46).build(lobes, mesh, dice);
    }
}
