package nephele.engine.reference;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.bvh.SpatialIndex;
import org.joml.Vector3dc;

/**
 * All items of a level that rays intersect. They are numbered solids first, then the pieces of bodies, then models, then
 * terrains, then billboards, then models of fields.
 * Safe to share between threads.
 */
final class TracedItems {
    /** The factor on a hit's parameter beyond which rounding cannot place an item in front of the hit. */
    static final double BEHIND = 1 + 1e-9;

    private final TracedShape[] items;
    private final int[] surfaces;
    private final int solids;
    private final int firstModel;
    private final int firstGround;
    private final double[] bounds;
    private final SpatialIndex index;

    /**
     * Collects the items.
     *
     * @param bodies number of bodies, however many pieces portals cut them into
     */
    TracedItems(
            StaticShapes statics,
            List<BodyPiece> pieces,
            int bodies,
            List<BillboardShape> billboards,
            List<TriangleMeshShape.Planted> plants) {
        List<TracedShape> all = new ArrayList<>();
        List<TracedShape> tracedModels = new ArrayList<>();
        List<TracedShape> tracedGrounds = new ArrayList<>();
        statics.forEach(
                hull -> all.add(new TracedSolid(hull.brush().shape())),
                mesh -> tracedModels.add(new TriangleMeshShape(mesh.model())),
                grid -> tracedGrounds.add(new GroundShape(grid)));
        solids = all.size();
        int models = tracedModels.size();
        firstModel = solids + pieces.size();
        firstGround = firstModel + models;
        int grounds = tracedGrounds.size();
        all.addAll(pieces);
        all.addAll(tracedModels);
        all.addAll(tracedGrounds);
        all.addAll(billboards);
        all.addAll(plants);
        items = all.toArray(TracedShape[]::new);
        surfaces = Stream.of(
                        IntStream.range(0, solids),
                        pieces.stream().mapToInt(piece -> solids + piece.body()),
                        IntStream.range(0, models + grounds).map(other -> solids + bodies + other),
                        billboards.stream()
                                .mapToInt(billboard -> solids + bodies + models + grounds + billboard.number()),
                        plants.stream().mapToInt(plant -> solids + bodies + plant.model()))
                .flatMapToInt(numbers -> numbers)
                .toArray();
        List<Aabb> boxes = all.stream().map(TracedShape::bounds).toList();
        bounds = boxes.stream()
                .flatMapToDouble(b -> DoubleStream.of(b.minX(), b.minY(), b.minZ(), b.maxX(), b.maxY(), b.maxZ()))
                .toArray();
        index = SpatialIndex.of(boxes);
    }

    static Ray ray(Vector3dc origin, Vector3dc direction) {
        return new Ray(origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z());
    }

    int count() {
        return items.length;
    }

    TracedShape shape(int item) {
        return items[item];
    }

    /**
     * Returns the item to exclude from the shadow rays of a lit item: itself if it is convex, otherwise −1 for none.
     */
    int withoutOwnShade(int item) {
        return item < 0 || items[item].shadesItself() ? -1 : item;
    }

    /**
     * Returns the index of a solid, the number of solids plus that of a body, of both plus that of a model, of all three plus
     * that of a terrain, or of all four plus that of a group of billboards.
     */
    int surface(int item) {
        return surfaces[item];
    }

    /** Returns the kind of an item at which a ray of a bake ends. */
    GatherRays.End endOf(int item) {
        TracedShape shape = items[item];
        if (shape instanceof TracedSolid) {
            return GatherRays.End.SOLID;
        }
        if (shape instanceof TriangleMeshShape) {
            return GatherRays.End.MODEL;
        }
        return shape instanceof GroundShape ? GatherRays.End.GROUND : GatherRays.End.OTHER;
    }

    /** Returns the index of a solid, model or terrain in the level. */
    int indexOf(int item) {
        return switch (endOf(item)) {
            case MODEL -> item - firstModel;
            case GROUND -> item - firstGround;
            default -> item;
        };
    }

    boolean isSolid(int surface) {
        return surface >= 0 && surface < solids;
    }

    /** Returns the parameter at which a ray from outside enters a solid; infinity if it does not. */
    double entry(Ray ray, int solid) {
        return items[solid].entry(ray, 0, Double.POSITIVE_INFINITY);
    }

    /**
     * Finds the first item that the ray enters at a parameter from {@code least} to {@code most}.
     *
     * @param except an item that the ray passes, or −1
     * @param likely an item that the ray probably enters first, or −1: items clearly behind it are skipped, and the
     *     result does not depend on it
     */
    boolean nearest(Ray ray, double least, double most, int except, int likely, RayHit hit) {
        double behind = likely < 0 ? Double.POSITIVE_INFINITY : BEHIND * items[likely].entry(ray, least, most);
        return behind < most && nearest(ray, least, behind, except, hit) || nearest(ray, least, most, except, hit);
    }

    private boolean nearest(Ray ray, double least, double most, int except, RayHit hit) {
        return index.nearest(
                ray,
                most,
                (r, item, limit) -> item == except ? Double.POSITIVE_INFINITY : items[item].entry(r, least, limit),
                hit);
    }

    /** Returns an item other than {@code except} that the ray intersects up to the parameter {@code limit}, or −1. */
    int blocker(Ray ray, double limit, int except) {
        int[] found = {-1};
        index.anyHit(ray, limit, (r, item, most) -> {
            if (item == except || !isBlockedBy(item, r, most)) {
                return Double.POSITIVE_INFINITY;
            }
            found[0] = item;
            return 0;
        });
        return found[0];
    }

    /** Returns all items that rays of the shaft may intersect. */
    int[] near(ShaftShape shape) {
        IntStream.Builder items = IntStream.builder();
        index.query(shape, items::add);
        return items.build().toArray();
    }

    /**
     * Returns the shaft with those of some items that its rays may intersect, nearest first.
     *
     * @param items all that are {@link #near} this shaft or a wider one
     */
    Shafts.Shaft shaft(ShaftShape shape, int[] items) {
        long[] met = new long[items.length];
        int count = 0;
        for (int i = 0; i < items.length; i++) {
            double entry = shape.entry(bounds, 6 * items[i]);
            if (entry < Double.POSITIVE_INFINITY) {
                met[count++] = nearer(entry, i);
            }
        }
        Arrays.sort(met, 0, count);
        return new Shafts.Shaft(
                this,
                Arrays.stream(met, 0, count).mapToInt(key -> items[(int) key]).toArray());
    }

    /** Returns a key that sorts by {@code entry} ≥ 0, then by index. It only affects speed: a float suffices. */
    private static long nearer(double entry, int place) {
        return (long) Float.floatToIntBits((float) entry) << 32 | place;
    }

    /** Returns the first item with a box that the ray intersects up to {@code limit}, as {@link Ray#firstBox}. */
    int firstBox(Ray ray, double limit, int[] items, int from, int to) {
        return ray.firstBox(limit, bounds, items, from, to);
    }

    /** Returns true if the ray intersects one item up to the parameter {@code limit}. */
    boolean isBlockedBy(int item, Ray ray, double limit) {
        return items[item].intersects(ray, limit);
    }
}
