package nephele.engine.collision;

import java.util.List;
import java.util.function.IntConsumer;
import nephele.engine.math.Aabb;
import nephele.engine.math.IdentityDiff;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemRayTest;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.bvh.SpatialIndex;
import nephele.engine.math.heightfield.HeightField;

/** Some of a world's colliders, numbered from 0 and indexed by their bounding boxes. */
sealed interface ColliderSet {
    int size();

    Collider collider(int item);

    /** Returns the bounding box of all of them; empty for none. */
    Aabb bounds();

    /** Returns the ray parameter at which a ray enters a collider, infinity for a miss. */
    double entry(Ray ray, int item, RayCast by);

    /**
     * Finds the nearest hit by the caller's own test, the lowest item among equally near ones; returns false for none.
     */
    boolean nearest(Ray ray, double limit, ItemRayTest test, RayHit hit);

    /** Visits all colliders with boxes that overlap or touch a box. */
    void overlapping(Aabb box, IntConsumer found);

    /**
     * Does the same for a box of six numbers of an array from {@code at} on: three least, three greatest coordinates.
     */
    void overlapping(double[] box, int at, IntConsumer found);

    /** Visits all colliders with boxes that a box may touch while it moves by {@code motion}. */
    void swept(Aabb box, Vec3 motion, IntConsumer found);

    /** Colliders stored one by one, in a spatial index. */
    final class Listed implements ColliderSet {
        private final List<Collider> colliders;
        private final SpatialIndex index;

        Listed(List<Collider> colliders) {
            this(colliders, SpatialIndex.of(boxes(colliders)));
        }

        private Listed(List<Collider> colliders, SpatialIndex index) {
            this.colliders = List.copyOf(colliders);
            this.index = index;
        }

        private static List<Aabb> boxes(List<Collider> colliders) {
            return colliders.stream().map(Collider::bounds).toList();
        }

        /** Returns a set of other colliders, or this one when all are the same. */
        Listed edited(List<Collider> others) {
            return IdentityDiff.list(colliders, others) == colliders
                    ? this
                    : new Listed(others, index.edited(boxes(others)));
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
        public void overlapping(Aabb box, IntConsumer found) {
            index.overlapping(box, found);
        }

        @Override
        public void overlapping(double[] box, int at, IntConsumer found) {
            index.overlapping(box, at, found);
        }

        @Override
        public void swept(Aabb box, Vec3 motion, IntConsumer found) {
            index.swept(box, motion, found);
        }
    }

    /**
     * The triangles of a height field, each a {@link Collider#triangle} built on request and not stored. Rays are tested against
     * the triangles themselves, so that none passes through along an edge.
     */
    final class Ground implements ColliderSet {
        private final String id;
        private final HeightField field;

        Ground(String id, HeightField field) {
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
            return Collider.triangle(
                    id, field.corner(item, 0), field.corner(item, 1), field.corner(item, 2), field.normal(item));
        }

        @Override
        public Aabb bounds() {
            return field.bounds().grown(Collider.TRIANGLE_DEPTH_METRES);
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
        public void overlapping(Aabb box, IntConsumer found) {
            if (!box.isEmpty()) {
                Aabb reached = box.grown(Collider.TRIANGLE_DEPTH_METRES);
                field.passing(reached::overlaps, found);
            }
        }

        @Override
        public void overlapping(double[] box, int at, IntConsumer found) {
            overlapping(new Aabb(box[at], box[at + 1], box[at + 2], box[at + 3], box[at + 4], box[at + 5]), found);
        }

        @Override
        public void swept(Aabb box, Vec3 motion, IntConsumer found) {
            if (!box.isEmpty()) {
                field.swept(box.grown(Collider.TRIANGLE_DEPTH_METRES), motion, found);
            }
        }
    }
}
