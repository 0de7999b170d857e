package nephele.engine.collision.rigid.solver;

import java.util.Arrays;

/** Bodies connected by contacts, as disjoint sets (Tarjan 1975); a set's lowest index is its root. Reused. */
public final class Islands {
    private int[] parent = new int[0];

    public void reset(int bodies) {
        if (parent.length < bodies) {
            parent = new int[bodies];
        }
        for (int i = 0; i < bodies; i++) {
            parent[i] = i;
        }
    }

    public int root(int body) {
        int at = body;
        while (parent[at] != at) {
            parent[at] = parent[parent[at]];
            at = parent[at];
        }
        return at;
    }

    public void join(int a, int b) {
        int ra = root(a);
        int rb = root(b);
        parent[Math.max(ra, rb)] = Math.min(ra, rb);
    }

    /** Writes for each root the least of its bodies' values, and infinity for the others. */
    public void least(float[] values, int bodies, float[] out) {
        Arrays.fill(out, 0, bodies, Float.POSITIVE_INFINITY);
        for (int i = 0; i < bodies; i++) {
            int r = root(i);
            out[r] = Math.min(out[r], values[i]);
        }
    }
}
