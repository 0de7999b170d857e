package nephele.lab.generate;

import java.util.ArrayList;
import java.util.List;
import nephele.lab.generate.PlantKind.Family;
import org.joml.Vector3d;

/** A cypress: a dark flame of upright lobes around a hidden trunk. */
final class CypressTree {
    static final PlantKind KIND = new PlantKind(Family.TREE, "cypress", 7, CypressTree::grow);

    private static final int ROWS = 9;

    private CypressTree() {}

    private static void grow(PlantMesh mesh, PlantDice dice) {
        Skeleton skeleton = new Skeleton(new Vector3d(0, -0.25, 0));
        List<Clump> lobes = new ArrayList<>();
        int top = 0;
        for (int row = 0; row < ROWS; row++) {
            double share = (row + 0.5) / ROWS;
            double y = 0.75 + 5.2 * share;
            top = skeleton.add(new Vector3d(0, y - 0.4, 0), top);
            double wide = 0.72 * StrictMath.pow(StrictMath.sin(StrictMath.PI * (0.16 + 0.84 * share)), 0.8);
            int around = row > ROWS - 2 ? 1 : row > ROWS - 4 ? 3 : 5;
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
}
