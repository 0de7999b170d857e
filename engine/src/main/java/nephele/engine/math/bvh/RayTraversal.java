package nephele.engine.math.bvh;

import nephele.engine.math.Ray;

/** Traverses a {@link SpatialTree} with rays; has no per-query state. */
final class RayTraversal {
    private final SpatialTree tree;
    /** For each node, the node after its subtree in depth-first order; the traversal continues there after a miss. */
    private final int[] after;

    RayTraversal(SpatialTree tree) {
        this.tree = tree;
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

    boolean nearest(Ray ray, double limit, ItemRayTest test, RayHit hit) {
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

    /** Iterates instead of recursing, because any-hit queries are called millions of times. */
    boolean anyHit(Ray ray, double limit, ItemRayTest test) {
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
}
