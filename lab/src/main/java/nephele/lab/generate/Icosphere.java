package nephele.lab.generate;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.joml.Vector3d;

/**
 * An icosahedron whose triangles are divided into four, again and again, on the unit sphere.
 *
 * @param triangles three directions each, counter-clockwise seen from outside
 */
record Icosphere(List<Vector3d> directions, List<int[]> triangles) {
    private static final double GOLDEN = (1 + StrictMath.sqrt(5)) / 2;
    private static final int[][] FACES = {
        {0, 11, 5},
        {0, 5, 1},
        {0, 1, 7},
        {0, 7, 10},
        {0, 10, 11},
        {1, 5, 9},
        {5, 11, 4},
        {11, 10, 2},
        {10, 7, 6},
        {7, 1, 8},
        {3, 9, 4},
        {3, 4, 2},
        {3, 2, 6},
        {3, 6, 8},
        {3, 8, 9},
        {4, 9, 5},
        {2, 4, 11},
        {6, 2, 10},
        {8, 6, 7},
        {9, 8, 1}
    };

    /** Returns 20 · 4^divisions triangles. */
    static Icosphere of(int divisions) {
        List<Vector3d> corners = new ArrayList<>();
        for (int axis = 0; axis < 3; axis++) {
            for (int[] sign : new int[][] {{-1, 1}, {1, 1}, {-1, -1}, {1, -1}}) {
                double[] xyz = new double[3];
                xyz[axis] = sign[0];
                xyz[(axis + 1) % 3] = sign[1] * GOLDEN;
                corners.add(new Vector3d(xyz[0], xyz[1], xyz[2]).normalize());
            }
        }
        Icosphere sphere = new Icosphere(corners, List.of(FACES));
        for (int i = 0; i < divisions; i++) {
            sphere = sphere.divided();
        }
        return sphere;
    }

    private Icosphere divided() {
        List<Vector3d> all = new ArrayList<>(directions);
        Map<Long, Integer> middles = new HashMap<>();
        List<int[]> parts = new ArrayList<>();
        for (int[] t : triangles) {
            int ab = middle(t[0], t[1], all, middles);
            int bc = middle(t[1], t[2], all, middles);
            int ca = middle(t[2], t[0], all, middles);
            parts.add(new int[] {t[0], ab, ca});
            parts.add(new int[] {t[1], bc, ab});
            parts.add(new int[] {t[2], ca, bc});
            parts.add(new int[] {ab, bc, ca});
        }
        return new Icosphere(all, parts);
    }

    private static int middle(int a, int b, List<Vector3d> all, Map<Long, Integer> middles) {
        return middles.computeIfAbsent((long) Math.min(a, b) << 32 | Math.max(a, b), key -> {
            all.add(new Vector3d(all.get(a)).add(all.get(b)).normalize());
            return all.size() - 1;
        });
    }
}
