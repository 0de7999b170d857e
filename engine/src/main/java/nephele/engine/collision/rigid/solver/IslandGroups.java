package nephele.engine.collision.rigid.solver;

import java.util.Arrays;

/** The manifolds of a step, sorted by island: an island is a set of movable bodies connected by contacts. Reused. */
final class IslandGroups {
    private final ContactRows rows;
    private final SolverState motions;
    private final Islands islands = new Islands();
    /** The manifolds' numbers, island by island. */
    private int[] order = new int[0];

    private int count;
    private int[] next = new int[0];
    private int[] firstOf = new int[0];

    IslandGroups(ContactRows rows, SolverState motions) {
        this.rows = rows;
        this.motions = motions;
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
        int root = root(order[from]);
        int end = from + 1;
        while (end < count && root(order[end]) == root) {
            end++;
        }
        return end;
    }

    /** Sorts the manifolds by island; within an island they stay in order. */
    void find(int slots) {
        islands.reset(slots);
        for (int m = 0; m < rows.count; m++) {
            int a = rows.slotA[m];
            int b = rows.slotB[m];
            if (a < slots && b < slots && motions.inverseMass[a] > 0 && motions.inverseMass[b] > 0) {
                islands.join(a, b);
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
            int r = root(m);
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

    private int root(int m) {
        int a = rows.slotA[m];
        return islands.root(motions.inverseMass[a] > 0 ? a : rows.slotB[m]);
    }
}
