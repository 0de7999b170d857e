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

    /** Builds the same tree as {@link #build()}, copying subtrees of another tree that cover the same boxes. */
    SpatialTree build(SpatialTree other, List<Aabb> given) {
        known = new RefittedTree(other, given);
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

    /** Item counts and bounds along one axis, for the cheapest split by surface area. */
    private static final class SahBins {
        private final int bins;
        private final int[] count;
        private final double[] bounds;
        private final double[] costAfter;
        private final double[] sweep = new double[6];
        private double low;
        private double scale;

        SahBins(int bins) {
            this.bins = bins;
            count = new int[bins];
            bounds = new double[6 * bins];
            costAfter = new double[bins];
        }

        /** Clears the bins for centres in [low, high]; returns false if the interval is too narrow to be divided. */
        boolean start(double lowest, double highest) {
            low = lowest;
            scale = bins / (highest - lowest);
            Arrays.fill(count, 0);
            return scale > 0 && scale <= Double.MAX_VALUE;
        }

        int binOf(double centre) {
            return Math.min(bins - 1, (int) ((centre - low) * scale));
        }

        void add(double centre, double[] boxes, int at) {
            int bin = binOf(centre);
            if (count[bin]++ == 0) {
                System.arraycopy(boxes, at, bounds, 6 * bin, 6);
            } else {
                grow(bounds, 6 * bin, boxes, at);
            }
        }

        /**
         * Returns the last bin of the left side of the cheapest split. Empty bins are skipped: a split after one costs the
         * same as the split before it. Both sides hold items, because the lowest centre is in the first bin and the highest
         * in the last.
         */
        int cheapest() {
            sweepFromRight();
            clearSweep();
            int left = 0;
            int best = 0;
            for (int bin = 0; bin < bins - 1; bin++) {
                if (count[bin] == 0) {
                    continue;
                }
                left += count[bin];
                grow(sweep, 0, bounds, 6 * bin);
                costAfter[bin] += left * halfArea(sweep);
                if (costAfter[bin] < costAfter[best]) {
                    best = bin;
                }
            }
            return best;
        }

        double cost(int bin) {
            return costAfter[bin];
        }

        private void sweepFromRight() {
            clearSweep();
            int rightCount = 0;
            double cost = 0;
            for (int bin = bins - 1; bin > 0; bin--) {
                if (count[bin] > 0) {
                    rightCount += count[bin];
                    grow(sweep, 0, bounds, 6 * bin);
                    cost = rightCount * halfArea(sweep);
                }
                costAfter[bin - 1] = cost;
            }
        }

        private void clearSweep() {
            Arrays.fill(sweep, 0, 3, Double.POSITIVE_INFINITY);
            Arrays.fill(sweep, 3, 6, Double.NEGATIVE_INFINITY);
        }

        private static double halfArea(double[] box) {
            double x = box[3] - box[0];
            double y = box[4] - box[1];
            double z = box[5] - box[2];
            return x < 0 ? 0 : x * y + y * z + z * x;
        }
    }

    /** An existing tree from which a new tree over a similar list of boxes copies the subtrees over unchanged boxes. */
    private static final class RefittedTree {
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
}
