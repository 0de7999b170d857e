package nephele.engine.math.bvh;

import java.util.Arrays;
import java.util.List;
import nephele.engine.math.Aabb;

/** An existing tree from which a new tree over a similar list of boxes copies the subtrees over unchanged boxes. */
final class RefittedTree {
    /** The value for no node or no item. */
    static final int NONE = -1;

    private final SpatialTree tree;
    /** For each item of this tree its index in the other list, and the reverse; {@link #NONE} if there is none. */
    private final int[] now;

    private final int[] before;
    private final int[] slotOf;

    /**
     * Matches equal boxes at equal indices. If the lists differ in length, the boxes up to the first difference are
     * matched from the start, the others from the end.
     */
    RefittedTree(SpatialTree tree, List<Aabb> others) {
        this.tree = tree;
        int size = tree.itemAtSlot().length;
        slotOf = new int[size];
        for (int slot = 0; slot < size; slot++) {
            slotOf[tree.itemAtSlot()[slot]] = slot;
        }
        now = new int[size];
        before = new int[others.size()];
        Arrays.fill(now, NONE);
        Arrays.fill(before, NONE);
        int shift = others.size() - size;
        int first = 0;
        while (shift != 0 && first < Math.min(size, others.size()) && isSame(first, others.get(first))) {
            pair(first, first);
            first++;
        }
        for (int item = Math.max(first, first - shift); item < size; item++) {
            if (isSame(item, others.get(item + shift))) {
                pair(item, item + shift);
            }
        }
    }

    private void pair(int item, int other) {
        now[item] = other;
        before[other] = item;
    }

    private boolean isSame(int item, Aabb box) {
        double[] b = tree.slotBounds();
        int at = 6 * slotOf[item];
        return b[at] == box.minX()
                && b[at + 1] == box.minY()
                && b[at + 2] == box.minZ()
                && b[at + 3] == box.maxX()
                && b[at + 4] == box.maxY()
                && b[at + 5] == box.maxZ();
    }

    int root() {
        return tree.nodes() > 0 ? 0 : NONE;
    }

    int left(int node) {
        return tree.right()[node] < 0 ? NONE : node + 1;
    }

    int right(int node) {
        return tree.right()[node] < 0 ? NONE : tree.right()[node];
    }

    /** Returns true if a node covers exactly these items of the other list. */
    boolean isOver(int node, int[] items, int from, int to) {
        int first = tree.first()[node];
        int end = tree.end()[node];
        if (end - first != to - from) {
            return false;
        }
        for (int i = from; i < to; i++) {
            int item = before[items[i]];
            if (item == NONE || slotOf[item] < first || slotOf[item] >= end) {
                return false;
            }
        }
        return true;
    }

    /**
     * Copies a subtree and its items.
     *
     * @param items of the other list, in slot order
     * @param from the subtree's first slot in the other list
     * @param to index of the subtree's first node in {@code into}
     * @return the number of nodes copied
     */
    int copy(int node, int[] items, int from, int to, SpatialTree into) {
        int last = node;
        while (tree.right()[last] >= 0) {
            last = tree.right()[last];
        }
        int count = last + 1 - node;
        int shift = from - tree.first()[node];
        System.arraycopy(tree.nodeBounds(), 6 * node, into.nodeBounds(), 6 * to, 6 * count);
        for (int i = 0; i < count; i++) {
            into.first()[to + i] = tree.first()[node + i] + shift;
            into.end()[to + i] = tree.end()[node + i] + shift;
            int right = tree.right()[node + i];
            into.right()[to + i] = right < 0 ? right : right + to - node;
        }
        for (int slot = tree.first()[node]; slot < tree.end()[node]; slot++) {
            items[slot + shift] = now[tree.itemAtSlot()[slot]];
        }
        return count;
    }
}
