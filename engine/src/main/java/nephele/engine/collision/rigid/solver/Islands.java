package nephele.engine.collision.rigid.solver;

import java.util.Arrays;

/**
 * Bodies connected by contacts, as disjoint sets (Tarjan 1975); a set's lowest index is its root. For the solver, the
 * manifolds of a step sorted by these sets. Reused.
 */
public final class Islands {
    private int[] parent = new int[0];
    private ContactRows rows;
    private SolverState motions;
    /** The manifolds' numbers, island by island. */
    private int[] order = new int[0];

    private int count;
    private int[] next = new int[0];
    private int[] firstOf = new int[0];

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

    /** Returns the manifolds' numbers, island by island; {@link #count} of them are valid. */
    int[] order() {
        return order;
    }

    int count() {
        return count;
    }

    /** Returns the end of the island that begins at a place of the order. */
    int end(int from) {
        int root = rootOf(order[from]);
        int end = from + 1;
        while (end < count && rootOf(order[end]) == root) {
            end++;
        }
        return end;
    }

    /** Sorts the manifolds by island; within an island they stay in order. */
    void sort(ContactRows contacts, SolverState slotMotions, int slots) {
        rows = contacts;
        motions = slotMotions;
        reset(slots);
        for (int m = 0; m < rows.count; m++) {
            int a = rows.slotA[m];
            int b = rows.slotB[m];
            if (a < slots && b < slots && motions.inverseMass[a] > 0 && motions.inverseMass[b] > 0) {
                join(a, b);
            }
        }
        if (order.length < rows.count) {
            order = new int[2 * rows.count];
            next = new int[2 * rows.count];
        }
        if (firstOf.length < slots) {
            firstOf = new int[slots + 64];
        }
        Arrays.fill(firstOf, 0, slots, -1);
        for (int m = rows.count - 1; m >= 0; m--) {
            int r = rootOf(m);
            next[m] = firstOf[r];
            firstOf[r] = m;
        }
        count = 0;
        for (int slot = 0; slot < slots; slot++) {
            for (int m = firstOf[slot]; m >= 0; m = next[m]) {
                order[count++] = m;
            }
        }
    }

    private int rootOf(int m) {
        int a = rows.slotA[m];
        return root(motions.inverseMass[a] > 0 ? a : rows.slotB[m]);
    }
}
