package nephele.engine.collision;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntConsumer;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Aabb;
import nephele.engine.math.IdentityDiff;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.math.bvh.ItemRayTest;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.heightfield.HeightField;
import org.joml.Vector3dc;

/**
 * The static collision geometry. A level without solids gives an empty world. A world can be derived from another with
 * a few solids replaced; it shares the rest, and a shared solid keeps its index.
 */
public final class CollisionWorld {
    /** No solid of the base is absent. */
    private static final long[] ALL = new long[0];

    private final ColliderSet own;
    /** The world with which this one shares solids; {@code null} for none. */
    private final CollisionWorld base;
    /** One bit for each solid of the base, up to the last absent one; set if the solid is absent here. */
    private final long[] absent;
    /** The static shapes that this world was built from; {@code null} if it was not built from static shapes. */
    private final StaticShapes statics;

    /** Makes a world of these colliders; their indices are those in the list. */
    public CollisionWorld(List<Collider> colliders) {
        this(new ColliderSet.Listed(colliders), null, ALL);
    }

    private CollisionWorld(ColliderSet own, CollisionWorld base, long[] absent) {
        this(own, base, absent, null);
    }

    private CollisionWorld(ColliderSet own, CollisionWorld base, long[] absent, StaticShapes statics) {
        this.own = own;
        this.base = base;
        this.absent = absent;
        this.statics = statics;
    }

    /**
     * Builds the world of a level without models.
     *
     * @throws IllegalArgumentException when a solid encloses no volume; the level rules report that first
     */
    public static CollisionWorld of(Level level) {
        return of(StaticShapes.of(level));
    }

    /**
     * Builds a world: first solids and convex models, then each triangle of other models, then each triangle of the
     * ground.
     */
    public static CollisionWorld of(StaticShapes shapes) {
        CollisionWorld nothing =
                new CollisionWorld(new ColliderSet.Listed(List.of()), null, ALL, StaticShapes.of(List.of()));
        return nothing.edited(shapes);
    }

    /**
     * Returns the world of an edited level, as {@link #of} builds it. Colliders of unchanged shape are reused, and this
     * world is returned when all are unchanged.
     *
     * @throws IllegalStateException when this is not the world of a level
     */
    public CollisionWorld edited(StaticShapes others) {
        if (statics == null) {
            throw new IllegalStateException("only the world of a level's shapes can be edited");
        }
        if (others == statics) {
            return this;
        }
        ColliderSet.Listed before = listed();
        ColliderSet.Listed now = before.edited(colliders(others));
        if (now == before && others.ground().equals(statics.ground())) {
            return this;
        }
        CollisionWorld world = new CollisionWorld(now, null, ALL, others);
        for (StaticShape.HeightGrid grid : others.ground()) {
            world = world.with(grid);
        }
        return world;
    }

    /** Returns the colliders of shapes that are not ground, the convex ones first; those of this world are reused. */
    private List<Collider> colliders(StaticShapes shapes) {
        int[] placeOfSolid = IdentityDiff.previousIndices(statics.solids(), shapes.solids());
        int[] placeOfModel = IdentityDiff.previousIndices(triangles(statics), triangles(shapes));
        int[] itemOfModel = itemOfModel(statics);
        List<Collider> convex = new ArrayList<>();
        List<Collider> sheets = new ArrayList<>();
        shapes.forEach(
                hull -> {
                    int index = hull.index();
                    int place = placeOfSolid[index];
                    // A solid with a changed surface is another brush of the same shape, at the same place.
                    boolean isReplaced = place == IdentityDiff.NEW
                            && index < statics.solids().size();
                    convex.add(collider(isReplaced ? index : place, hull.brush()));
                },
                mesh -> {
                    PlacedModel model = mesh.model();
                    int place = placeOfModel[model.index()];
                    int item = place == IdentityDiff.NEW ? IdentityDiff.NEW : itemOfModel[place];
                    if (model.solid() != null) {
                        convex.add(collider(item, model.solid()));
                    } else if (item == IdentityDiff.NEW) {
                        sheets.addAll(Collider.triangles(model.authored().id(), model.triangles()));
                    } else {
                        for (int i = 0; i < model.triangles().count(); i++) {
                            sheets.add(collider(item + i));
                        }
                    }
                },
                grid -> {});
        convex.addAll(sheets);
        return convex;
    }

    private static List<WorldTriangles> triangles(StaticShapes shapes) {
        return shapes.models().all().stream().map(PlacedModel::triangles).toList();
    }

    /** Returns the first item of each model in the world of some shapes. */
    private static int[] itemOfModel(StaticShapes shapes) {
        List<PlacedModel> models = shapes.models().all();
        int[] items = new int[models.size()];
        int convexItem = shapes.solids().size();
        int sheetItem = convexItem + shapes.models().solids().size();
        for (int i = 0; i < items.length; i++) {
            boolean isConvex = models.get(i).solid() != null;
            items[i] = isConvex ? convexItem++ : sheetItem;
            sheetItem += isConvex ? 0 : models.get(i).triangles().count();
        }
        return items;
    }

    /**
     * Returns the collider of a brush: one of this world if it has the same id and shape.
     *
     * @param item {@link IdentityDiff#NEW} if this world has none
     */
    private Collider collider(int item, Brush brush) {
        Collider known = item == IdentityDiff.NEW ? null : collider(item);
        boolean isSame = known != null
                && known.solidId().equals(brush.solidId())
                && known.shape().equals(brush.shape());
        return isSame ? known : new Collider(brush.solidId(), brush.shape());
    }

    /** Returns the colliders that are not ground, in the world of a level. */
    private ColliderSet.Listed listed() {
        return base == null ? (ColliderSet.Listed) own : base.listed();
    }

    /**
     * Returns this world with some of its solids replaced; takes time proportional to the replacement.
     *
     * @param without indices in this world
     * @param added get the indices from {@link #size} on
     */
    CollisionWorld replacing(ItemList without, List<Collider> added) {
        int end = 0;
        for (int i = 0; i < without.size(); i++) {
            end = Math.max(end, 1 + (without.get(i) >> 6));
        }
        long[] bits = new long[end];
        for (int i = 0; i < without.size(); i++) {
            bits[without.get(i) >> 6] |= 1L << without.get(i);
        }
        return new CollisionWorld(new ColliderSet.Listed(added), this, bits);
    }

    /** Returns this world with more colliders, which get the indices from {@link #size} on. */
    public CollisionWorld with(List<Collider> added) {
        return new CollisionWorld(new ColliderSet.Listed(added), this, ALL);
    }

    /** Returns this world with ground; its triangles get the indices from {@link #size} on. */
    private CollisionWorld with(StaticShape.HeightGrid grid) {
        Math.addExact(size(), grid.field().triangles());
        return new CollisionWorld(new ColliderSet.Ground(grid.id(), grid.field()), this, ALL, statics);
    }

    /** Returns one more than the greatest index. */
    public int size() {
        return shared() + own.size();
    }

    private int shared() {
        return base == null ? 0 : base.size();
    }

    /** Returns a solid by its index; also one that was replaced. */
    public Collider collider(int item) {
        return item < shared() ? base.collider(item) : own.collider(item - shared());
    }

    /** Returns true if a solid is a triangle of ground. */
    boolean isGround(int item) {
        return item < shared() ? base.isGround(item) : own instanceof ColliderSet.Ground;
    }

    /** Returns the fields of all ground. */
    List<HeightField> grounds() {
        List<HeightField> all = new ArrayList<>();
        for (CollisionWorld world = this; world != null; world = world.base) {
            if (world.own instanceof ColliderSet.Ground ground) {
                all.add(ground.field());
            }
        }
        return all;
    }

    /** Returns the bounding box of all solids, replaced ones included; empty for an empty world. */
    public Aabb extent() {
        return base == null ? own.bounds() : base.extent().union(own.bounds());
    }

    private boolean isAbsent(int item) {
        return item >> 6 < absent.length && (absent[item >> 6] & 1L << item) != 0;
    }

    /** Finds the nearest hit by the caller's own test; returns false for none. */
    boolean nearest(Ray ray, double limit, ItemRayTest test, RayHit hit) {
        if (base == null) {
            return own.nearest(ray, limit, test, hit);
        }
        RayHit ownHit = new RayHit();
        int offset = shared();
        own.nearest(ray, limit, (r, item, most) -> test.hit(r, item + offset, most), ownHit);
        base.nearest(
                ray,
                limit,
                (r, item, most) -> isAbsent(item) ? Double.POSITIVE_INFINITY : test.hit(r, item, most),
                hit);
        if (ownHit.item() >= 0) {
            hit.offer(ownHit.item() + offset, ownHit.distance());
        }
        return hit.item() >= 0;
    }

    /** Returns the ray parameter at which a ray enters a solid, infinity for a miss. */
    double entry(Ray ray, int item, RayCast by) {
        return item < shared() ? base.entry(ray, item, by) : own.entry(ray, item - shared(), by);
    }

    /** Fills {@code found} with the solids of which the box touches {@code box}, in ascending order. */
    public void overlapping(Aabb box, ItemList found) {
        found.clear();
        collect(box, found);
        found.sort();
    }

    private void collect(Aabb box, IntConsumer found) {
        if (base != null) {
            base.collect(box, present(found));
        }
        own.overlapping(box, own(found));
    }

    /**
     * Does the same for a box of six numbers of an array from {@code at} on: three least, three greatest coordinates.
     */
    public void overlapping(double[] box, int at, ItemList found) {
        found.clear();
        collect(box, at, found);
        found.sort();
    }

    private void collect(double[] box, int at, IntConsumer found) {
        if (base != null) {
            base.collect(box, at, present(found));
        }
        own.overlapping(box, at, own(found));
    }

    /**
     * Fills {@code found} with the colliders that a shape may touch along a displacement, in ascending order.
     *
     * @param margin in metres around the shape
     */
    void near(RoundedHull shape, Vector3dc from, Vector3dc path, double margin, ItemList found) {
        found.clear();
        Aabb box = new Aabb(
                from.x() + shape.least(0) - margin,
                from.y() + shape.least(1) - margin,
                from.z() + shape.least(2) - margin,
                from.x() + shape.greatest(0) + margin,
                from.y() + shape.greatest(1) + margin,
                from.z() + shape.greatest(2) + margin);
        collectSwept(box, new Vec3(path.x(), path.y(), path.z()), found);
        found.sort();
    }

    private void collectSwept(Aabb box, Vec3 motion, IntConsumer found) {
        if (base != null) {
            base.collectSwept(box, motion, present(found));
        }
        own.swept(box, motion, own(found));
    }

    private IntConsumer present(IntConsumer found) {
        return item -> {
            if (!isAbsent(item)) {
                found.accept(item);
            }
        };
    }

    private IntConsumer own(IntConsumer found) {
        int offset = shared();
        return offset == 0 ? found : item -> found.accept(item + offset);
    }
}
