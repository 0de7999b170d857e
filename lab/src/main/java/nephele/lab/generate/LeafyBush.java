package nephele.lab.generate;

import java.util.ArrayList;
import java.util.List;
import nephele.lab.generate.PlantKind.Family;
import org.joml.Vector3d;

/** A bush: stems that spread from the ground under round lobes, with pale blossoms. */
final class LeafyBush {
    static final PlantKind KIND = new PlantKind(Family.TREE, "bush", 1.4, LeafyBush::grow);

    private static final int STEMS = 9;
    private static final int BLOSSOMS = 26;
    private static final double BLOSSOM_METRES = 0.045;

    private LeafyBush() {}

    private static void grow(PlantMesh mesh, PlantDice dice) {
        Skeleton skeleton = new Skeleton(new Vector3d(0, -0.1, 0));
        List<Clump> lobes = new ArrayList<>();
        for (int i = 0; i <= STEMS; i++) {
            double turn = 2 * StrictMath.PI * (i + dice.around(0.2)) / STEMS;
            double away = i == STEMS ? 0 : dice.between(0.42, 0.66);
            double y = i == STEMS ? 0.98 : 0.86 - 0.62 * away + dice.around(0.14);
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
}
