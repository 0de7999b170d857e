package nephele.engine.math.bvh;

import java.util.List;
import java.util.function.IntConsumer;
import nephele.engine.math.Aabb;
import nephele.engine.math.Frustum;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/**
 * A bounding volume hierarchy for culling, collision and rays. Building sorts the items into <em>slots</em> so that
 * every subtree is one run of slots: vertices laid out by slot can be drawn a subtree at a time. Queries allocate
 * nothing and may run in several threads. Empty boxes are never reported; boxes with an infinite side are tested one by
 * one.
 */
public final class SpatialIndex {
    private static final int DEFAULT_LEAF_ITEMS = 4;

    private final SpatialTree tree;
    private final int leafItems;

    /** For each node, the node after its subtree in depth-first order; a search for any hit continues there after a miss. */
    private final int[] after;

    private SpatialIndex(SpatialTree tree, int leafItems) {
        this.tree = tree;
        this.leafItems = leafItems;
        after = new int[tree.nodes()];
        if (after.length > 0) {
            after[0] = after.length;
        }
        for (int node = 0; node < after.length; node++) {
            int right = tree.right()[node];
            if (right >= 0) {
                after[node + 1] = right;
                after[right] = after[node];
            }
        }
    }

    public static SpatialIndex of(List<Aabb> boxes) {
        return of(boxes, DEFAULT_LEAF_ITEMS);
    }

    /**
     * Builds an index.
     *
     * @param leafItems maximum number of items in a leaf; they are tested one by one
     */
    public static SpatialIndex of(List<Aabb> boxes, int leafItems) {
        return new SpatialIndex(new SpatialTreeBuilder(boxes, leafItems).build(), leafItems);
    }

    /**
     * Returns the index that building anew would return; fast if most boxes are those of this index, in the same order.
     */
    public SpatialIndex edited(List<Aabb> boxes) {
        return new SpatialIndex(new SpatialTreeBuilder(boxes, leafItems).build(tree, boxes), leafItems);
    }

    /** Returns the number of items given, including empty boxes. */
    public int size() {
        return tree.itemAtSlot().length;
    }

    /** Returns the item in {@code slot}, by its index in the given list. */
    public int itemAt(int slot) {
        return tree.itemAtSlot()[slot];
    }

    /** Returns the box that contains all items that are not empty. */
    public Aabb bounds() {
        Aabb all = Aabb.EMPTY;
        for (int slot = 0; slot < tree.emptyFrom(); slot++) {
            all = all.union(box(tree.slotBounds(), slot));
        }
        return all;
    }

    private static Aabb box(double[] bounds, int index) {
        int at = 6 * index;
        return new Aabb(bounds[at], bounds[at + 1], bounds[at + 2], bounds[at + 3], bounds[at + 4], bounds[at + 5]);
    }

    /**
     * Reports runs of slots that cover everything the frustum may see, nearer subtrees first. A subtree inside all
     * planes is one run and is not tested further.
     */
    public void cull(Frustum frustum, RangeVisitor visible) {
        if (tree.unbounded() > 0) {
            visible.range(0, tree.unbounded());
        }
        if (tree.nodes() > 0) {
            cull(0, frustum.allPlanes(), frustum, visible);
        }
    }

    /** Reports a subtree front to back; each node tests only the planes that intersect its parent's box. */
    private void cull(int node, int mask, Frustum frustum, RangeVisitor visible) {
        int cut = frustum.classify(tree.nodeBounds(), 6 * node, mask);
        if (cut == Frustum.OUTSIDE) {
            return;
        }
        int right = tree.right()[node];
        if (cut == 0) {
            visible.range(tree.first()[node], tree.end()[node]);
        } else if (right < 0) {
            cullLeaf(node, cut, frustum, visible);
        } else if (rightIsNearer(node, right, frustum)) {
            cull(right, cut, frustum, visible);
            cull(node + 1, cut, frustum, visible);
        } else {
            cull(node + 1, cut, frustum, visible);
            cull(right, cut, frustum, visible);
        }
    }

    private void cullLeaf(int node, int mask, Frustum frustum, RangeVisitor visible) {
        int end = tree.end()[node];
        int from = tree.first()[node];
        for (int slot = from; slot < end; slot++) {
            if (frustum.classify(tree.slotBounds(), 6 * slot, mask) == Frustum.OUTSIDE) {
                if (slot > from) {
                    visible.range(from, slot);
                }
                from = slot + 1;
            }
        }
        if (end > from) {
            visible.range(from, end);
        }
    }

    private boolean rightIsNearer(int node, int right, Frustum frustum) {
        return squareDistance(right, frustum) < squareDistance(node + 1, frustum);
    }

    private double squareDistance(int node, Frustum frustum) {
        double[] b = tree.nodeBounds();
        int at = 6 * node;
        double x = b[at] / 2 + b[at + 3] / 2 - frustum.eyeX();
        double y = b[at + 1] / 2 + b[at + 4] / 2 - frustum.eyeY();
        double z = b[at + 2] / 2 + b[at + 5] / 2 - frustum.eyeZ();
        return x * x + y * y + z * z;
    }

    /** Culls as {@link #cull}, but tests the bounding sphere of each box linearly. */
    public void cullSpheres(Frustum frustum, RangeVisitor visible) {
        int runStart = 0;
        for (int slot = 0; slot < tree.emptyFrom(); slot++) {
            if (slot >= tree.unbounded() && !frustum.maySeeSphere(tree.slotBounds(), 6 * slot)) {
                if (slot > runStart) {
                    visible.range(runStart, slot);
                }
                runStart = slot + 1;
            }
        }
        if (tree.emptyFrom() > runStart) {
            visible.range(runStart, tree.emptyFrom());
        }
    }

    /** Reports every item with a box that overlaps or touches {@code box}, in tree order. */
    public void overlapping(Aabb box, IntConsumer found) {
        if (box.isEmpty()) {
            return;
        }
        overlapping(box, 0, tree.unbounded(), found);
        if (tree.nodes() > 0) {
            overlapping(0, box, found);
        }
    }

    private void overlapping(int node, Aabb box, IntConsumer found) {
        if (!box.overlaps(tree.nodeBounds(), 6 * node)) {
            return;
        }
        int right = tree.right()[node];
        if (right < 0) {
            overlapping(box, tree.first()[node], tree.end()[node], found);
        } else {
            overlapping(node + 1, box, found);
            overlapping(right, box, found);
        }
    }

    private void overlapping(Aabb box, int firstSlot, int endSlot, IntConsumer found) {
        for (int slot = firstSlot; slot < endSlot; slot++) {
            if (box.overlaps(tree.slotBounds(), 6 * slot)) {
                found.accept(tree.itemAtSlot()[slot]);
            }
        }
    }

    /**
     * Reports every item with a box that overlaps or touches the one in {@code box} at {@code at}: three minima, three
     * maxima.
     */
    public void overlapping(double[] box, int at, IntConsumer found) {
        overlappingSlots(box, at, 0, tree.unbounded(), found);
        if (tree.nodes() > 0) {
            overlappingNode(0, box, at, found);
        }
    }

    private void overlappingNode(int node, double[] box, int at, IntConsumer found) {
        if (!overlaps(tree.nodeBounds(), 6 * node, box, at)) {
            return;
        }
        int right = tree.right()[node];
        if (right < 0) {
            overlappingSlots(box, at, tree.first()[node], tree.end()[node], found);
        } else {
            overlappingNode(node + 1, box, at, found);
            overlappingNode(right, box, at, found);
        }
    }

    private void overlappingSlots(double[] box, int at, int firstSlot, int endSlot, IntConsumer found) {
        for (int slot = firstSlot; slot < endSlot; slot++) {
            if (overlaps(tree.slotBounds(), 6 * slot, box, at)) {
                found.accept(tree.itemAtSlot()[slot]);
            }
        }
    }

    private static boolean overlaps(double[] bounds, int i, double[] box, int j) {
        return bounds[i] <= box[j + 3]
                && box[j] <= bounds[i + 3]
                && bounds[i + 1] <= box[j + 4]
                && box[j + 1] <= bounds[i + 4]
                && bounds[i + 2] <= box[j + 5]
                && box[j + 2] <= bounds[i + 5];
    }

    /**
     * Finds the nearest hit by the caller's test, the lowest item among equally near ones.
     *
     * @param limit greatest ray parameter that counts
     * @return true if there is a hit; then {@code hit} holds it
     */
    public boolean nearest(Ray ray, double limit, ItemRayTest test, RayHit hit) {
        hit.reset(limit);
        nearest(ray, 0, tree.unbounded(), test, hit);
        if (tree.nodes() > 0 && ray.boxEntry(tree.nodeBounds(), 0, limit) <= limit) {
            nearest(ray, 0, test, hit);
        }
        return hit.item() >= 0;
    }

    private void nearest(Ray ray, int node, ItemRayTest test, RayHit hit) {
        int right = tree.right()[node];
        if (right < 0) {
            nearest(ray, tree.first()[node], tree.end()[node], test, hit);
            return;
        }
        double leftEntry = ray.boxEntry(tree.nodeBounds(), 6 * (node + 1), hit.distance());
        double rightEntry = ray.boxEntry(tree.nodeBounds(), 6 * right, hit.distance());
        boolean rightFirst = rightEntry < leftEntry;
        double nearEntry = rightFirst ? rightEntry : leftEntry;
        double farEntry = rightFirst ? leftEntry : rightEntry;
        if (isFiniteAndWithin(nearEntry, hit)) {
            nearest(ray, rightFirst ? right : node + 1, test, hit);
        }
        if (isFiniteAndWithin(farEntry, hit)) {
            nearest(ray, rightFirst ? node + 1 : right, test, hit);
        }
    }

    private static boolean isFiniteAndWithin(double entry, RayHit hit) {
        return entry < Double.POSITIVE_INFINITY && entry <= hit.distance();
    }

    private void nearest(Ray ray, int firstSlot, int endSlot, ItemRayTest test, RayHit hit) {
        for (int slot = firstSlot; slot < endSlot; slot++) {
            if (isFiniteAndWithin(ray.boxEntry(tree.slotBounds(), 6 * slot, hit.distance()), hit)) {
                int item = tree.itemAtSlot()[slot];
                double distance = test.hit(ray, item, hit.distance());
                if (distance < Double.POSITIVE_INFINITY) {
                    hit.offer(item, distance);
                }
            }
        }
    }

    /**
     * Returns true if the caller's test hits any item up to {@code limit}. It iterates instead of recursing, because it is
     * called millions of times.
     */
    public boolean anyHit(Ray ray, double limit, ItemRayTest test) {
        if (anyHit(ray, 0, tree.unbounded(), limit, test)) {
            return true;
        }
        double[] bounds = tree.nodeBounds();
        int[] right = tree.right();
        int node = 0;
        while (node < after.length) {
            if (ray.boxEntry(bounds, 6 * node, limit) == Double.POSITIVE_INFINITY) {
                node = after[node];
            } else if (right[node] < 0 && anyHit(ray, tree.first()[node], tree.end()[node], limit, test)) {
                return true;
            } else {
                node++;
            }
        }
        return false;
    }

    private boolean anyHit(Ray ray, int firstSlot, int endSlot, double limit, ItemRayTest test) {
        for (int slot = firstSlot; slot < endSlot; slot++) {
            if (ray.boxEntry(tree.slotBounds(), 6 * slot, limit) < Double.POSITIVE_INFINITY) {
                double distance = test.hit(ray, tree.itemAtSlot()[slot], limit);
                if (distance <= limit && distance < Double.POSITIVE_INFINITY) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Reports every item with a box that passes, in tree order. */
    public void query(BoxTest test, IntConsumer found) {
        query(test, 0, tree.unbounded(), found);
        if (tree.nodes() > 0) {
            query(test, 0, found);
        }
    }

    private void query(BoxTest test, int node, IntConsumer found) {
        if (!test.passes(tree.nodeBounds(), 6 * node)) {
            return;
        }
        int right = tree.right()[node];
        if (right < 0) {
            query(test, tree.first()[node], tree.end()[node], found);
        } else {
            query(test, node + 1, found);
            query(test, right, found);
        }
    }

    private void query(BoxTest test, int firstSlot, int endSlot, IntConsumer found) {
        for (int slot = firstSlot; slot < endSlot; slot++) {
            if (test.passes(tree.slotBounds(), 6 * slot)) {
                found.accept(tree.itemAtSlot()[slot]);
            }
        }
    }

    /** Reports every item with a box that {@code box} may touch along {@code motion}, in tree order. */
    public void swept(Aabb box, Vec3 motion, IntConsumer found) {
        SweptAabb sweep = SweptAabb.of(box, motion);
        query(sweep, 0, tree.unbounded(), found);
        if (tree.nodes() > 0 && !box.isEmpty()) {
            query(sweep, 0, found);
        }
    }
}
