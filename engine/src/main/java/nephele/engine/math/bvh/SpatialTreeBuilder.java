package nephele.engine.math.bvh;

import java.util.Arrays;
import java.util.List;
import nephele.engine.math.Aabb;

/**
 * Builds a tree by the binned surface area heuristic (Wald 2007, "On fast Construction of SAH-based Bounding Volume
 * Hierarchies"). Partitioning is stable, so equal input gives the equal tree, and the items of each node are in
 * ascending order before it is split.
 */
final class SpatialTreeBuilder {
    private static final int BINS = 16;

    /** Below this depth subtrees are halved by count, which bounds the recursion of queries. */
    private static final int MAX_HEURISTIC_DEPTH = 40;

    private final int leafItems;
    private final double[] boxes;
    /** Three numbers for each box. */
    private final double[] centres;

    private final SahBins[] bins = {new SahBins(BINS), new SahBins(BINS), new SahBins(BINS)};
    private final int[] items;
    private final int[] scratch;
    private final int unbounded;
    private final int emptyFrom;

    private double[] nodeBounds;
    private int[] first;
    private int[] end;
    private int[] right;
    private int nodes;
    /** A tree over some of the same boxes; {@code null} for none. */
    private RefittedTree known;

    SpatialTreeBuilder(List<Aabb> given, int leafItems) {
        this.leafItems = Math.max(1, leafItems);
        boxes = new double[6 * given.size()];
        centres = new double[3 * given.size()];
        items = new int[given.size()];
        scratch = new int[given.size()];
        int infinite = 0;
        int empty = 0;
        for (int i = 0; i < given.size(); i++) {
            Aabb box = given.get(i);
            write(box, boxes, 6 * i);
            for (int axis = 0; axis < 3; axis++) {
                centres[3 * i + axis] = boxes[6 * i + axis] / 2 + boxes[6 * i + 3 + axis] / 2;
            }
            if (box.isEmpty()) {
                empty++;
            } else if (Aabb.isUnbounded(boxes, 6 * i)) {
                infinite++;
            }
        }
        unbounded = infinite;
        emptyFrom = given.size() - empty;
        sortIntoGroups(given);
        int capacity = Math.max(0, 2 * (emptyFrom - unbounded) - 1);
        nodeBounds = new double[6 * capacity];
        first = new int[capacity];
        end = new int[capacity];
        right = new int[capacity];
    }

    private static void write(Aabb box, double[] bounds, int at) {
        bounds[at] = box.minX();
        bounds[at + 1] = box.minY();
        bounds[at + 2] = box.minZ();
        bounds[at + 3] = box.maxX();
        bounds[at + 4] = box.maxY();
        bounds[at + 5] = box.maxZ();
    }

    private void sortIntoGroups(List<Aabb> given) {
        int infinite = 0;
        int finite = unbounded;
        int empty = emptyFrom;
        for (int i = 0; i < given.size(); i++) {
            if (given.get(i).isEmpty()) {
                items[empty++] = i;
            } else if (Aabb.isUnbounded(boxes, 6 * i)) {
                items[infinite++] = i;
            } else {
                items[finite++] = i;
            }
        }
    }

    /** Builds the same tree as {@link #build()}, copying subtrees of {@code over} that cover the same boxes. */
    SpatialTree build(RefittedTree over) {
        known = over;
        return build();
    }

    SpatialTree build() {
        if (emptyFrom > unbounded) {
            node(unbounded, emptyFrom, 0, known == null ? RefittedTree.NONE : known.root());
        }
        double[] slotBounds = new double[boxes.length];
        for (int slot = 0; slot < items.length; slot++) {
            System.arraycopy(boxes, 6 * items[slot], slotBounds, 6 * slot, 6);
        }
        return new SpatialTree(
                Arrays.copyOf(nodeBounds, 6 * nodes),
                Arrays.copyOf(first, nodes),
                Arrays.copyOf(end, nodes),
                Arrays.copyOf(right, nodes),
                slotBounds,
                items,
                unbounded,
                emptyFrom);
    }

    /** @param like the node at this place of the known tree */
    private int node(int from, int to, int depth, int like) {
        int node = nodes;
        if (like != RefittedTree.NONE && known.isOver(like, items, from, to)) {
            nodes += known.copy(
                    like, items, from, node, new SpatialTree(nodeBounds, first, end, right, null, null, 0, 0));
            return node;
        }
        nodes++;
        bound(from, to, nodeBounds, 6 * node);
        first[node] = from;
        end[node] = to;
        right[node] = -1;
        if (to - from > leafItems) {
            int middle = depth < MAX_HEURISTIC_DEPTH ? split(from, to) : (from + to) >>> 1;
            node(from, middle, depth + 1, like == RefittedTree.NONE ? like : known.left(like));
            right[node] = node(middle, to, depth + 1, like == RefittedTree.NONE ? like : known.right(like));
        }
        return node;
    }

    private void bound(int from, int to, double[] bounds, int at) {
        Arrays.fill(bounds, at, at + 3, Double.POSITIVE_INFINITY);
        Arrays.fill(bounds, at + 3, at + 6, Double.NEGATIVE_INFINITY);
        for (int i = from; i < to; i++) {
            grow(bounds, at, boxes, 6 * items[i]);
        }
    }

    static void grow(double[] bounds, int at, double[] box, int boxAt) {
        for (int axis = 0; axis < 3; axis++) {
            bounds[at + axis] = Math.min(bounds[at + axis], box[boxAt + axis]);
            bounds[at + 3 + axis] = Math.max(bounds[at + 3 + axis], box[boxAt + 3 + axis]);
        }
    }

    /** Reorders the items of [from, to) and returns the start of the second half. */
    private int split(int from, int to) {
        double bestCost = Double.POSITIVE_INFINITY;
        int bestAxis = -1;
        int bestBin = 0;
        for (int axis = 0; axis < 3; axis++) {
            if (!fill(bins[axis], from, to, axis)) {
                continue;
            }
            int bin = bins[axis].cheapest();
            if (bins[axis].cost(bin) < bestCost) {
                bestCost = bins[axis].cost(bin);
                bestAxis = axis;
                bestBin = bin;
            }
        }
        return bestAxis < 0 ? (from + to) >>> 1 : partition(bins[bestAxis], from, to, bestAxis, bestBin);
    }

    /** Returns false if all centres coincide on this axis, which then cannot split the items. */
    private boolean fill(SahBins bins, int from, int to, int axis) {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int i = from; i < to; i++) {
            double centre = centres[3 * items[i] + axis];
            low = Math.min(low, centre);
            high = Math.max(high, centre);
        }
        if (!(low < high) || !bins.start(low, high)) {
            return false;
        }
        for (int i = from; i < to; i++) {
            bins.add(centres[3 * items[i] + axis], boxes, 6 * items[i]);
        }
        return true;
    }

    private int partition(SahBins bins, int from, int to, int axis, int lastLeftBin) {
        int left = from;
        int spilled = 0;
        for (int i = from; i < to; i++) {
            int item = items[i];
            if (bins.binOf(centres[3 * item + axis]) <= lastLeftBin) {
                items[left++] = item;
            } else {
                scratch[spilled++] = item;
            }
        }
        System.arraycopy(scratch, 0, items, left, spilled);
        return left;
    }
}
