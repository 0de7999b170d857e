package nephele.engine.collision;

import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.IdentityDiff;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemRayTest;
import nephele.engine.math.bvh.ItemVisitor;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.bvh.SpatialIndex;

/** Colliders stored one by one, in a spatial index. */
final class ListedColliders implements ColliderSet {
    private final List<Collider> colliders;
    private final SpatialIndex index;

    ListedColliders(List<Collider> colliders) {
        this(colliders, SpatialIndex.of(boxes(colliders)));
    }

    private ListedColliders(List<Collider> colliders, SpatialIndex index) {
        this.colliders = List.copyOf(colliders);
        this.index = index;
    }

    private static List<Aabb> boxes(List<Collider> colliders) {
        return colliders.stream().map(Collider::bounds).toList();
    }

    /** Returns a set of other colliders, or this one when all are the same. */
    ListedColliders edited(List<Collider> others) {
        return IdentityDiff.list(colliders, others) == colliders
                ? this
                : new ListedColliders(others, index.edited(boxes(others)));
    }

    @Override
    public int size() {
        return colliders.size();
    }

    @Override
    public Collider collider(int item) {
        return colliders.get(item);
    }

    @Override
    public Aabb bounds() {
        return index.bounds();
    }

    @Override
    public double entry(Ray ray, int item, RayCast by) {
        return by.entry(ray, colliders.get(item));
    }

    @Override
    public boolean nearest(Ray ray, double limit, ItemRayTest test, RayHit hit) {
        return index.nearest(ray, limit, test, hit);
    }

    @Override
    public void overlapping(Aabb box, ItemVisitor found) {
        index.overlapping(box, found);
    }

    @Override
    public void overlapping(double[] box, int at, ItemVisitor found) {
        index.overlapping(box, at, found);
    }

    @Override
    public void swept(Aabb box, Vec3 motion, ItemVisitor found) {
        index.swept(box, motion, found);
    }
}
