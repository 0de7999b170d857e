package nephele.lab.generate;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Tapered tubes around a branching structure. The thickest child continues a tube, the others begin new ones inside it;
 * at the ground the trunk widens into roots.
 *
 * @param leastMetres branches thinner than this at their start are left out
 * @param speckle the fraction of a tube's corners that are dark, as on a birch
 */
record BranchTubes(PlantPaint paint, double leastMetres, double speckle) {
    private static final double FLARE_METRES = 0.4;
    private static final int ROOTS = 5;

    void build(Skeleton skeleton, double[] radii, PlantMesh mesh, PlantDice dice) {
        List<int[]> starts = new ArrayList<>(List.<int[]>of(new int[] {0, -1}));
        for (int i = 0; i < starts.size(); i++) {
            List<Vector3d> line = new ArrayList<>();
            List<Double> thickness = new ArrayList<>();
            int node = starts.get(i)[0];
            if (starts.get(i)[1] >= 0) {
                line.add(new Vector3d(skeleton.point(starts.get(i)[1])));
                thickness.add(radii[node]);
            }
            while (node >= 0) {
                line.add(new Vector3d(skeleton.point(node)));
                thickness.add(radii[node]);
                node = continued(skeleton, radii, node, starts);
            }
            tube(thinned(line), thinned(thickness), mesh, dice);
        }
    }

    /** Returns the thickest child, −1 without any; the others are added to the starts. */
    private int continued(Skeleton skeleton, double[] radii, int node, List<int[]> starts) {
        int main = -1;
        for (int child : skeleton.children(node)) {
            main = main < 0 || radii[child] > radii[main] ? child : main;
        }
        for (int child : skeleton.children(node)) {
            if (child != main && radii[child] >= leastMetres) {
                starts.add(new int[] {child, node});
            }
        }
        return main;
    }

    /** Returns every second element and the last. */
    private static <T> List<T> thinned(List<T> all) {
        List<T> kept = new ArrayList<>();
        for (int i = 0; i < all.size() - 1; i += all.size() > 4 ? 2 : 1) {
            kept.add(all.get(i));
        }
        kept.add(all.get(all.size() - 1));
        return kept;
    }

    private void tube(List<Vector3d> line, List<Double> radii, PlantMesh mesh, PlantDice dice) {
        if (line.size() < 2) {
            return;
        }
        int sides = radii.get(0) > 0.1 ? 10 : radii.get(0) > 0.05 ? 6 : 4;
        Vector3d across = new Vector3d(1, 0, 0.01);
        int[] before = null;
        for (int i = 0; i < line.size() - 1; i++) {
            Vector3d along = new Vector3d(line.get(i + 1))
                    .sub(line.get(Math.max(0, i - 1)))
                    .normalize();
            across.fma(-across.dot(along), along).normalize();
            int[] ring = ring(line.get(i), radii.get(i), new Vector3d[] {along, across}, sides, mesh, dice);
            for (int side = 0; before != null && side < sides; side++) {
                int next = (side + 1) % sides;
                mesh.quad(before[side], before[next], ring[next], ring[side]);
            }
            before = ring;
        }
        Vector3d end = line.get(line.size() - 1);
        int tip = mesh.vertex(end, new Vector3d(end).sub(line.get(line.size() - 2)), paint, 0.5);
        for (int side = 0; side < sides; side++) {
            mesh.triangle(before[side], before[(side + 1) % sides], tip);
        }
    }

    private int[] ring(Vector3dc at, double radius, Vector3d[] frame, int sides, PlantMesh mesh, PlantDice dice) {
        Vector3d beside = new Vector3d(frame[1]).cross(frame[0]);
        double flare = Math.min(1, StrictMath.exp(-at.y() / FLARE_METRES));
        int[] ring = new int[sides];
        for (int side = 0; side < sides; side++) {
            double turn = 2 * StrictMath.PI * side / sides;
            Vector3d out = new Vector3d(frame[1]).mul(StrictMath.cos(turn)).fma(-StrictMath.sin(turn), beside);
            double roots = 1 + flare * (0.55 + 0.35 * StrictMath.cos(ROOTS * turn + 1));
            boolean dark = dice.between(0, 1) < speckle;
            double shade = dark ? 0 : (speckle > 0 ? 0.85 : 0.5) + dice.around(0.15) - 0.3 * flare;
            ring[side] = mesh.vertex(new Vector3d(at).fma(radius * roots, out), out, paint, shade);
        }
        return ring;
    }
}
