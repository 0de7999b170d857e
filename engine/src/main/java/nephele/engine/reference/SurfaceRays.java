package nephele.engine.reference;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import nephele.engine.level.Brush;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.RayHit;
import nephele.engine.math.SpatialIndex;
import org.joml.Vector3dc;

/**
 * What rays meet of convex solids, bodies and models. Each solid is taken as what lies behind all its planes: exact at edges, so
 * that touching solids leave no gap. Only outsides are seen: a ray that begins inside a thing does not see it. Items are
 * numbered solids first, then the pieces of bodies, then models. Safe to share between threads.
 */
final class SurfaceRays {
    /** Two faces that a ray meets within this share of its way are met on their edge. */
    private static final double EDGE = 1e-12;

    /** By this factor of its way a ray goes on behind a surface before nothing there can be in front by rounding. */
    private static final double BEHIND = 1 + 1e-9;

    private final double[][] planes;
    private final BodyPiece[] pieces;
    private final int bodies;
    private final ModelForms models;
    /** The number of the first model. */
    private final int firstModel;

    private final double[] bounds;
    private final SpatialIndex index;

    /** @param bodies how many there are, whatever portals cut them into */
    SurfaceRays(List<Brush> brushes, List<BodyPiece> pieces, int bodies, ModelForms models) {
        this.bodies = bodies;
        this.models = models;
        firstModel = brushes.size() + pieces.size();
        planes = brushes.stream().map(brush -> brush.shape().flatPlanes()).toArray(double[][]::new);
        this.pieces = pieces.toArray(BodyPiece[]::new);
        List<Aabb> boxes = new ArrayList<>();
        brushes.forEach(brush -> boxes.add(brush.shape().bounds()));
        pieces.forEach(piece -> boxes.add(piece.bounds()));
        boxes.addAll(models.bounds());
        bounds = boxes.stream()
                .flatMapToDouble(b -> DoubleStream.of(b.minX(), b.minY(), b.minZ(), b.maxX(), b.maxY(), b.maxZ()))
                .toArray();
        index = SpatialIndex.of(boxes);
    }

    static Ray ray(Vector3dc origin, Vector3dc direction) {
        return new Ray(origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z());
    }

    /** {@code null} for what is not of a body. */
    BodyPiece piece(int item) {
        return item < planes.length || item >= firstModel ? null : pieces[item - planes.length];
    }

    /** The number of a model; negative for what is none. */
    int model(int item) {
        return item - firstModel;
    }

    /** What need not be looked at for the light on an item: itself, where it is convex; −1 for a model. */
    int withoutOwnShade(int item) {
        return item < firstModel ? item : -1;
    }

    /** The index of a solid, the number of solids plus that of a body, or the number of both plus that of a model. */
    int surface(int item) {
        if (item >= firstModel) {
            return planes.length + bodies + item - firstModel;
        }
        return item < planes.length ? item : planes.length + piece(item).body();
    }

    boolean isSolid(int item) {
        return item >= 0 && item < planes.length;
    }

    /** The parameter at which a ray from outside enters a solid; infinity where it does not. */
    double entry(Ray ray, int solid) {
        return entry(ray, planes[solid], 0);
    }

    /**
     * The first item that the ray enters at a parameter from {@code least} to {@code most}.
     *
     * @param likely an item that the ray may well enter first, or −1: what is clearly behind it is not looked at, the
     *     answer does not depend on it
     */
    boolean nearest(Ray ray, double least, double most, int likely, RayHit hit) {
        double behind = likely < 0 ? Double.POSITIVE_INFINITY : BEHIND * entry(ray, likely, least);
        return behind < most && nearest(ray, least, behind, hit) || nearest(ray, least, most, hit);
    }

    private boolean nearest(Ray ray, double least, double most, RayHit hit) {
        return index.nearest(ray, most, (r, item, limit) -> entry(r, item, least), hit);
    }

    private double entry(Ray ray, int item, double least) {
        if (item >= firstModel) {
            return models.entry(ray, item - firstModel, least);
        }
        return item < planes.length
                ? entry(ray, planes[item], least)
                : piece(item).entry(ray, least);
    }

    /** Which of its faces the ray enters a solid by; on an edge, the one that it meets more squarely. */
    int face(Ray ray, int solid) {
        double[] p = planes[solid];
        int entered = 0;
        double latest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < p.length; i += 4) {
            double rate = rate(ray, p, i);
            double parameter = -inFront(ray, p, i) / rate;
            double same = EDGE * Math.abs(parameter);
            boolean isSquarer = parameter > latest - same && rate < rate(ray, p, 4 * entered);
            if (rate < 0 && (parameter > latest + same || isSquarer)) {
                latest = parameter;
                entered = i / 4;
            }
        }
        return entered;
    }

    /** Whether the ray meets any item but {@code except} up to the parameter {@code limit}: one that it does, or −1. */
    int blocker(Ray ray, double limit, int except) {
        Blocker found = new Blocker(except);
        index.anyHit(ray, limit, found);
        return found.item;
    }

    /** All items that rays of the beam may meet. */
    int[] near(BeamShape shape) {
        IntStream.Builder items = IntStream.builder();
        index.passing(shape, items::add);
        return items.build().toArray();
    }

    /**
     * Those of some items that rays of the beam may meet, nearest first.
     *
     * @param items all that are {@link #near} this beam or a wider one
     */
    Beam beam(BeamShape shape, int[] items) {
        long[] met = new long[items.length];
        int count = 0;
        for (int i = 0; i < items.length; i++) {
            double entry = shape.entry(bounds, 6 * items[i]);
            if (entry < Double.POSITIVE_INFINITY) {
                met[count++] = nearer(entry, i);
            }
        }
        Arrays.sort(met, 0, count);
        return new Beam(
                this,
                Arrays.stream(met, 0, count).mapToInt(key -> items[(int) key]).toArray());
    }

    /** Sorts by what is met first, at {@code entry} ≥ 0, then by place in the list. Only for speed: a float will do. */
    private static long nearer(double entry, int place) {
        return (long) Float.floatToIntBits((float) entry) << 32 | place;
    }

    /** The first of some items whose box the ray meets up to the parameter {@code limit}, as {@link Ray#firstBox}. */
    int firstBox(Ray ray, double limit, int[] items, int from, int to) {
        return ray.firstBox(limit, bounds, items, from, to);
    }

    /** Whether the ray meets one item up to the parameter {@code limit}. */
    boolean isBlockedBy(int item, Ray ray, double limit) {
        if (item >= firstModel) {
            return models.meets(ray, item - firstModel, limit);
        }
        return item < planes.length
                ? meets(ray, planes[item], limit)
                : piece(item).meets(ray, limit);
    }

    private final class Blocker implements nephele.engine.math.ItemRayTest {
        private final int except;
        private int item = -1;

        Blocker(int except) {
            this.except = except;
        }

        @Override
        public double hit(Ray ray, int candidate, double limit) {
            if (candidate == except || !isBlockedBy(candidate, ray, limit)) {
                return Double.POSITIVE_INFINITY;
            }
            item = candidate;
            return 0;
        }
    }

    /** The parameter at which the ray comes in; infinity where it does so before {@code least}, or never. */
    private static double entry(Ray ray, double[] p, double least) {
        double enter = Double.NEGATIVE_INFINITY;
        double leave = Double.POSITIVE_INFINITY;
        for (int i = 0; i < p.length && enter <= leave; i += 4) {
            double rate = rate(ray, p, i);
            double front = inFront(ray, p, i);
            if (rate < 0) {
                enter = Math.max(enter, -front / rate);
            } else if (rate > 0) {
                leave = Math.min(leave, -front / rate);
            } else if (front > 0) {
                return Double.POSITIVE_INFINITY;
            }
        }
        return enter < leave && enter >= least ? enter : Double.POSITIVE_INFINITY;
    }

    /** Clips the ray from 0 to {@code limit} by every plane (Cyrus and Beck 1978): what is left lies inside. */
    private static boolean meets(Ray ray, double[] p, double limit) {
        double enter = 0;
        double leave = limit;
        for (int i = 0; i < p.length && enter <= leave; i += 4) {
            double rate = rate(ray, p, i);
            double front = inFront(ray, p, i);
            if (rate < 0) {
                enter = Math.max(enter, -front / rate);
            } else if (rate > 0) {
                leave = Math.min(leave, -front / rate);
            } else if (front > 0) {
                return false;
            }
        }
        return enter <= leave;
    }

    private static double rate(Ray ray, double[] p, int plane) {
        return p[plane] * ray.directionX() + p[plane + 1] * ray.directionY() + p[plane + 2] * ray.directionZ();
    }

    private static double inFront(Ray ray, double[] p, int plane) {
        return p[plane] * ray.originX() + p[plane + 1] * ray.originY() + p[plane + 2] * ray.originZ() - p[plane + 3];
    }
}
