package nephele.engine.collision;

import nephele.engine.math.Aabb;
import nephele.engine.math.ItemRayTest;
import nephele.engine.math.ItemVisitor;
import nephele.engine.math.Ray;
import nephele.engine.math.RayHit;
import nephele.engine.math.Vec3;

/** Some of a world's colliders, numbered from 0 and found by their boxes. */
sealed interface ColliderSet permits ListedColliders, HeightFieldColliders {
    int size();

    Collider collider(int item);

    /** Around all of them; empty for none. */
    Aabb bounds();

    /** The ray parameter at which a ray enters one of them, infinity for a miss. */
    double entry(Ray ray, int item, RayCast by);

    /** The nearest hit by the caller's own test, the lowest item among equally near ones. */
    boolean nearest(Ray ray, double limit, ItemRayTest test, RayHit hit);

    /** All whose boxes overlap or touch a box. */
    void overlapping(Aabb box, ItemVisitor found);

    /** The same for six numbers of an array from {@code at} on: three least, three greatest. */
    void overlapping(double[] box, int at, ItemVisitor found);

    /** All whose boxes a box may touch on its way along {@code motion}. */
    void swept(Aabb box, Vec3 motion, ItemVisitor found);
}
