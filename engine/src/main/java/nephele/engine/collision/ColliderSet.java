package nephele.engine.collision;

import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemRayTest;
import nephele.engine.math.bvh.ItemVisitor;
import nephele.engine.math.bvh.RayHit;

/** Some of a world's colliders, numbered from 0 and indexed by their bounding boxes. */
sealed interface ColliderSet permits ListedColliders, HeightFieldColliders {
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
    void overlapping(Aabb box, ItemVisitor found);

    /**
     * Does the same for a box of six numbers of an array from {@code at} on: three least, three greatest coordinates.
     */
    void overlapping(double[] box, int at, ItemVisitor found);

    /** Visits all colliders with boxes that a box may touch while it moves by {@code motion}. */
    void swept(Aabb box, Vec3 motion, ItemVisitor found);
}
