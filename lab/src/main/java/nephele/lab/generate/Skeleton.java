package nephele.lab.generate;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** A branching structure that grows: nodes, each with the node that it grew from. Node 0 is the root. */
final class Skeleton {
    private final List<Vector3d> points = new ArrayList<>();
    private final List<Integer> parents = new ArrayList<>();
    private final List<List<Integer>> children = new ArrayList<>();

    Skeleton(Vector3dc root) {
        append(root, -1);
    }

    /** Adds a node and returns its index. */
    int add(Vector3dc point, int parent) {
        children.get(parent).add(points.size());
        return append(point, parent);
    }

    private int append(Vector3dc point, int parent) {
        points.add(new Vector3d(point));
        parents.add(parent);
        children.add(new ArrayList<>());
        return points.size() - 1;
    }

    int size() {
        return points.size();
    }

    Vector3dc point(int node) {
        return points.get(node);
    }

    List<Integer> children(int node) {
        return children.get(node);
    }

    /** Returns the nodes without children. */
    List<Integer> tips() {
        List<Integer> tips = new ArrayList<>();
        for (int node = 0; node < size(); node++) {
            if (children.get(node).isEmpty()) {
                tips.add(node);
            }
        }
        return tips;
    }

    /** Moves each inner node towards the middle of its parent and its children, so that branches bend softly. */
    void smooth() {
        List<Vector3d> before = points.stream().map(Vector3d::new).toList();
        for (int node = 1; node < size(); node++) {
            List<Integer> next = children.get(node);
            if (next.size() == 1) {
                Vector3d middle = new Vector3d(before.get(parents.get(node))).add(before.get(next.get(0)));
                points.get(node).mul(0.5).fma(0.25, middle);
            }
        }
    }

    /**
     * Returns the radius of each node: r^n is the sum of the children's r^n (Runions, Lane and Prusinkiewicz 2007,
     * "Modeling Trees with a Space Colonization Algorithm", section 3), scaled so that the root has the given radius.
     */
    double[] radii(double rootMetres, double exponent) {
        double[] power = new double[size()];
        for (int node = size() - 1; node >= 0; node--) {
            power[node] = children.get(node).isEmpty() ? 1 : power[node];
            if (node > 0) {
                power[parents.get(node)] += power[node];
            }
        }
        double[] radii = new double[size()];
        for (int node = 0; node < size(); node++) {
            radii[node] = rootMetres * StrictMath.pow(power[node] / power[0], 1 / exponent);
        }
        return radii;
    }
}
