package nephele.lab.generate;

import java.util.ArrayList;
import java.util.List;
import nephele.lab.generate.PlantKind.Family;
import org.joml.Vector3d;

/** An oak: a short strong trunk, wide boughs and a broad crown of lobes. */
final class OakTree {
    static final PlantKind KIND = new PlantKind(Family.TREE, "oak", 9, OakTree::grow);

    private static final SpaceColonisation GROWTH = new SpaceColonisation(0.45, 3.2, 0.95, 0.1);

    private OakTree() {}

    private static void grow(PlantMesh mesh, PlantDice dice) {
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
        GROWTH.grow(skeleton, space);
        skeleton.smooth();
        List<Clump> lobes = Lobes.atTips(skeleton, at -> {
            double size = dice.between(0.95, 1.25);
            return new Clump(new Vector3d(at).add(0, 0.15, 0), size, 0.78 * size);
        });
        new BranchTubes(PlantPaint.OAK_BARK, 0.035, 0).build(skeleton, skeleton.radii(0.34, 2.2), mesh, dice);
        new Foliage(PlantPaint.OAK_LEAF, crown, 0, 28, 0.74).build(lobes, mesh, dice);
    }
}
