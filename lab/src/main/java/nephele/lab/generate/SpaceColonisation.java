package nephele.lab.generate;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Growth into free space: attraction points pull the nearest node, which grows towards their mean direction; a point
 * that a node comes close to is used up (Runions, Lane and Prusinkiewicz 2007, "Modeling Trees with a Space
 * Colonization Algorithm", section 3).
 *
 * @param stepMetres from a node to the next
 * @param reachMetres the distance from which a point attracts a node
 * @param killMetres the distance at which a point is used up
 * @param lift the upward fraction of the direction of growth
 */
record SpaceColonisation(double stepMetres, double reachMetres, double killMetres, double lift) {
    private static final int MOST_ROUNDS = 80;
    private static final double LEAST_STEP_APART = 0.4;

    /** Lets the structure grow until no point attracts it. */
    void grow(Skeleton skeleton, List<Vector3d> attraction) {
        List<Vector3d> left = new ArrayList<>(attraction);
        boolean growing = true;
        for (int round = 0; round < MOST_ROUNDS && growing; round++) {
            growing = round(skeleton, left);
            left.removeIf(point -> distance(skeleton, nearest(skeleton, point), point) < killMetres);
        }
    }

    private boolean round(Skeleton skeleton, List<Vector3d> left) {
        int before = skeleton.size();
        Vector3d[] pull = new Vector3d[before];
        for (Vector3d point : left) {
            int node = nearest(skeleton, point);
            if (distance(skeleton, node, point) < reachMetres) {
                pull[node] = pull[node] == null ? new Vector3d() : pull[node];
                pull[node].add(new Vector3d(point).sub(skeleton.point(node)).normalize());
            }
        }
        for (int node = 0; node < before; node++) {
            if (pull[node] != null && pull[node].length() > 1e-6) {
                Vector3d step = pull[node].normalize().add(0, lift, 0).normalize(stepMetres);
                Vector3d next = step.add(skeleton.point(node));
                // Points on opposite sides would let a node grow to the same place for ever.
                if (distance(skeleton, nearest(skeleton, next), next) > LEAST_STEP_APART * stepMetres) {
                    skeleton.add(next, node);
                }
            }
        }
        return skeleton.size() > before;
    }

    private static int nearest(Skeleton skeleton, Vector3dc point) {
        int best = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int node = 0; node < skeleton.size(); node++) {
            double square = skeleton.point(node).distanceSquared(point);
            if (square < least) {
                least = square;
                best = node;
            }
        }
        return best;
    }

    private static double distance(Skeleton skeleton, int node, Vector3dc point) {
        return skeleton.point(node).distance(point);
    }
}
