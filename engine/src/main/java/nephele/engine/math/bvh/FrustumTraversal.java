package nephele.engine.math.bvh;

import nephele.engine.math.Frustum;

/** Traverses a tree front to back in a frustum; each node tests only the planes that intersect its parent's box. */
record FrustumTraversal(SpatialTree tree) {
    void subtree(int node, int mask, Frustum frustum, RangeVisitor visible) {
        int cut = frustum.classify(tree.nodeBounds(), 6 * node, mask);
        if (cut == Frustum.OUTSIDE) {
            return;
        }
        int right = tree.right()[node];
        if (cut == 0) {
            visible.range(tree.first()[node], tree.end()[node]);
        } else if (right < 0) {
            leaf(node, cut, frustum, visible);
        } else if (rightIsNearer(node, right, frustum)) {
            subtree(right, cut, frustum, visible);
            subtree(node + 1, cut, frustum, visible);
        } else {
            subtree(node + 1, cut, frustum, visible);
            subtree(right, cut, frustum, visible);
        }
    }

    private void leaf(int node, int mask, Frustum frustum, RangeVisitor visible) {
        int end = tree.end()[node];
        int runStart = tree.first()[node];
        for (int slot = runStart; slot < end; slot++) {
            if (frustum.classify(tree.slotBounds(), 6 * slot, mask) == Frustum.OUTSIDE) {
                if (slot > runStart) {
                    visible.range(runStart, slot);
                }
                runStart = slot + 1;
            }
        }
        if (end > runStart) {
            visible.range(runStart, end);
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
}
