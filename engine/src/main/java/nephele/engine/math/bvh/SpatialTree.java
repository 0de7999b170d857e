package nephele.engine.math.bvh;

/**
 * The arrays of a {@link SpatialIndex}: nodes in depth-first order, so that a left child follows its parent. Bounds are
 * six numbers each, minima first. Slots hold the {@code unbounded} items first, then those of the tree, and the empty
 * ones from {@code emptyFrom} on.
 *
 * @param first first slot of each node
 * @param end one past the last slot of each node
 * @param right the right child of each node, −1 for a leaf
 */
record SpatialTree(
        double[] nodeBounds,
        int[] first,
        int[] end,
        int[] right,
        double[] slotBounds,
        int[] itemAtSlot,
        int unbounded,
        int emptyFrom) {

    int nodes() {
        return first.length;
    }
}
