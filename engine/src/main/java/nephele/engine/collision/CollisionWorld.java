package nephele.engine.collision;

import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.math.Aabb;
import nephele.engine.math.ItemList;
import nephele.engine.math.SpatialIndex;
import nephele.engine.math.Vec3;
import org.joml.Vector3dc;

/** Everything solid that never moves. A level without solids gives an empty world. */
public final class CollisionWorld {
    private final List<Collider> colliders;
    private final SpatialIndex index;

    public CollisionWorld(List<Collider> colliders) {
        this.colliders = List.copyOf(colliders);
        index = SpatialIndex.of(colliders.stream().map(Collider::bounds).toList());
    }

    /** @throws IllegalArgumentException when a solid encloses no volume; the level rules say so first */
    public static CollisionWorld of(Level level) {
        return new CollisionWorld(level.solids().stream()
                .map(Brush::of)
                .map(brush -> new Collider(brush.solidId(), brush.shape()))
                .toList());
    }

    public int size() {
        return colliders.size();
    }

    public Collider collider(int index) {
        return colliders.get(index);
    }

    /** Around everything; empty for an empty world. */
    public Aabb extent() {
        return index.bounds();
    }

    SpatialIndex index() {
        return index;
    }

    /**
     * Fills {@code found} with the colliders that a shape may touch on its way, in ascending order.
     *
     * @param margin in metres around the shape
     */
    void near(RoundedHull shape, Vector3dc from, Vector3dc way, double margin, ItemList found) {
        found.clear();
        Aabb box = new Aabb(
                from.x() + shape.least(0) - margin,
                from.y() + shape.least(1) - margin,
                from.z() + shape.least(2) - margin,
                from.x() + shape.greatest(0) + margin,
                from.y() + shape.greatest(1) + margin,
                from.z() + shape.greatest(2) + margin);
        index.swept(box, new Vec3(way.x(), way.y(), way.z()), found);
        found.sort();
    }
}
