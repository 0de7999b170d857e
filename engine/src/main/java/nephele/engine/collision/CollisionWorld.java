package nephele.engine.collision;

import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.math.Aabb;

/** Everything solid that never moves. A level without solids gives an empty world. */
public final class CollisionWorld {
    private final List<Collider> colliders;
    private final double[] bounds;
    private final Aabb extent;

    public CollisionWorld(List<Collider> colliders) {
        this.colliders = List.copyOf(colliders);
        bounds = new double[6 * colliders.size()];
        Aabb all = Aabb.EMPTY;
        for (int i = 0; i < colliders.size(); i++) {
            Aabb b = colliders.get(i).bounds();
            all = all.union(b);
            double[] six = {b.minX(), b.minY(), b.minZ(), b.maxX(), b.maxY(), b.maxZ()};
            System.arraycopy(six, 0, bounds, 6 * i, 6);
        }
        extent = all;
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
        return extent;
    }

    /** Fills {@code found} with the colliders whose bounds meet the region, in ascending order. */
    void inside(Region region, IndexList found) {
        found.clear();
        for (int i = 0; i < colliders.size(); i++) {
            if (region.meets(bounds, 6 * i)) {
                found.add(i);
            }
        }
    }
}
