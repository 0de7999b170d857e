package nephele.engine.math.bvh;

import java.util.List;
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
    private final FrustumTraversal traversal;
    private final RayTraversal rays;

    private SpatialIndex(SpatialTree tree, int leafItems) {
        this.tree = tree;
        this.leafItems = leafItems;
        this.traversal = new FrustumTraversal(tree);
        this.rays = new RayTraversal(tree);
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
        RefittedTree known = new RefittedTree(tree, boxes);
        return new SpatialIndex(new SpatialTreeBuilder(boxes, leafItems).build(known), leafItems);
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
            traversal.subtree(0, frustum.allPlanes(), frustum, visible);
        }
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
    public void overlapping(Aabb box, ItemVisitor found) {
        if (box.isEmpty()) {
            return;
        }
        overlapping(box, 0, tree.unbounded(), found);
        if (tree.nodes() > 0) {
            overlapping(0, box, found);
        }
    }

    private void overlapping(int node, Aabb box, ItemVisitor found) {
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

    private void overlapping(Aabb box, int firstSlot, int endSlot, ItemVisitor found) {
        for (int slot = firstSlot; slot < endSlot; slot++) {
            if (box.overlaps(tree.slotBounds(), 6 * slot)) {
                found.item(tree.itemAtSlot()[slot]);
            }
        }
    }

    /**
     * Reports every item with a box that overlaps or touches the one in {@code box} at {@code at}: three minima, three
     * maxima.
     */
    public void overlapping(double[] box, int at, ItemVisitor found) {
        overlappingSlots(box, at, 0, tree.unbounded(), found);
        if (tree.nodes() > 0) {
            overlappingNode(0, box, at, found);
        }
    }

    private void overlappingNode(int node, double[] box, int at, ItemVisitor found) {
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

    private void overlappingSlots(double[] box, int at, int firstSlot, int endSlot, ItemVisitor found) {
        for (int slot = firstSlot; slot < endSlot; slot++) {
            if (overlaps(tree.slotBounds(), 6 * slot, box, at)) {
                found.item(tree.itemAtSlot()[slot]);
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
        return rays.nearest(ray, limit, test, hit);
    }

    /** Returns true if the caller's test hits any item up to {@code limit}. */
    public boolean anyHit(Ray ray, double limit, ItemRayTest test) {
        return rays.anyHit(ray, limit, test);
    }

    /** Reports every item with a box that passes, in tree order. */
    public void query(BoxTest test, ItemVisitor found) {
        query(test, 0, tree.unbounded(), found);
        if (tree.nodes() > 0) {
            query(test, 0, found);
        }
    }

    private void query(BoxTest test, int node, ItemVisitor found) {
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

    private void query(BoxTest test, int firstSlot, int endSlot, ItemVisitor found) {
        for (int slot = firstSlot; slot < endSlot; slot++) {
            if (test.passes(tree.slotBounds(), 6 * slot)) {
                found.item(tree.itemAtSlot()[slot]);
            }
        }
    }

    /** Reports every item with a box that {@code box} may touch along {@code motion}, in tree order. */
    public void swept(Aabb box, Vec3 motion, ItemVisitor found) {
        SweptAabb sweep = SweptAabb.of(box, motion);
        swept(sweep, 0, tree.unbounded(), found);
        if (tree.nodes() > 0 && !box.isEmpty()) {
            swept(sweep, 0, found);
        }
    }

    private void swept(SweptAabb sweep, int node, ItemVisitor found) {
        if (!sweep.touches(tree.nodeBounds(), 6 * node)) {
            return;
        }
        int right = tree.right()[node];
        if (right < 0) {
            swept(sweep, tree.first()[node], tree.end()[node], found);
        } else {
            swept(sweep, node + 1, found);
            swept(sweep, right, found);
        }
    }

    private void swept(SweptAabb sweep, int firstSlot, int endSlot, ItemVisitor found) {
        for (int slot = firstSlot; slot < endSlot; slot++) {
            if (sweep.touches(tree.slotBounds(), 6 * slot)) {
                found.item(tree.itemAtSlot()[slot]);
            }
        }
    }
}
