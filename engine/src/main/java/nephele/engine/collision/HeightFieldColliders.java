package nephele.engine.collision;

import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemRayTest;
import nephele.engine.math.bvh.ItemVisitor;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.heightfield.HeightField;

/**
 * The triangles of a height field, each a {@link TriangleCollider} built on request and not stored. Rays are tested against
 * the triangles themselves, so that none passes through along an edge.
 */
final class HeightFieldColliders implements ColliderSet {
    private final String id;
    private final HeightField field;

    HeightFieldColliders(String id, HeightField field) {
        this.id = id;
        this.field = field;
    }

    HeightField field() {
        return field;
    }

    @Override
    public int size() {
        return field.triangles();
    }

    @Override
    public Collider collider(int item) {
        return TriangleCollider.of(
                id, field.corner(item, 0), field.corner(item, 1), field.corner(item, 2), field.normal(item));
    }

    @Override
    public Aabb bounds() {
        return field.bounds().grown(TriangleCollider.DEPTH_METRES);
    }

    @Override
    public double entry(Ray ray, int item, RayCast by) {
        return field.entry(ray, item);
    }

    @Override
    public boolean nearest(Ray ray, double limit, ItemRayTest test, RayHit hit) {
        return field.nearest(ray, limit, test, hit);
    }

    @Override
    public void overlapping(Aabb box, ItemVisitor found) {
        if (!box.isEmpty()) {
            Aabb reached = box.grown(TriangleCollider.DEPTH_METRES);
            field.passing(reached::overlaps, found);
        }
    }

    @Override
    public void overlapping(double[] box, int at, ItemVisitor found) {
        overlapping(new Aabb(box[at], box[at + 1], box[at + 2], box[at + 3], box[at + 4], box[at + 5]), found);
    }

    @Override
    public void swept(Aabb box, Vec3 motion, ItemVisitor found) {
        if (!box.isEmpty()) {
            field.swept(box.grown(TriangleCollider.DEPTH_METRES), motion, found);
        }
    }
}
