package nephele.engine.reference;

import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Function;
import nephele.engine.math.Aabb;
import nephele.engine.math.Hash64;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import org.joml.Vector3dc;

/**
 * Sorts shadow rays into shafts (Haines and Wallace 1991), each from one cube of space to one punctual light, to the
 * sun or to a patch of the sky, and finds the items near a shaft once for all its rays. A shaft is made on first use.
 * Shared by all threads: two may make the same shaft, but none sees an incomplete one.
 */
final class Shafts {
    private static final double CUBE_METRES = 1;

    /** At greater distances from the origin in metres no shafts are used. */
    private static final double FARTHEST_METRES = 1e6;

    /** Patches of the sky along each side of a face of the cube of directions. */
    private static final int SIDE = 4;

    private static final int FACE_PATCHES = SIDE * SIDE;

    /** The number of cubes kept, a power of two. A cube takes a few kB, under a sky above 10 000 solids a hundred. */
    private static final int MOST_CUBES = 1 << 14;

    /** The limit on the memory of the shafts; the number of cubes does not bound it. */
    private static final long MOST_BYTES = 1L << 28;

    private final TracedItems surfaces;
    private final List<Function<Aabb, ShaftShape>> lights;
    private final long mostBytes;
    private volatile Kept kept = new Kept();

    /** All cached shafts, dropped together: making them again at most doubles the time. */
    private static final class Kept {
        private final Cube[] cubes = new Cube[MOST_CUBES];
        /** The size of all shafts made, including those of replaced cubes. */
        private final AtomicLong bytes = new AtomicLong();
    }

    /** The shafts that start in one cube of space. */
    static final class Cube {
        private final int x;
        private final int y;
        private final int z;
        private final Shaft[] shafts;

        private Cube(int x, int y, int z, int shafts) {
            this.x = x;
            this.y = y;
            this.z = z;
            this.shafts = new Shaft[shafts];
        }

        private boolean isAt(int otherX, int otherY, int otherZ) {
            return x == otherX && y == otherY && z == otherZ;
        }

        private Aabb box() {
            return new Aabb(
                    x * CUBE_METRES,
                    y * CUBE_METRES,
                    z * CUBE_METRES,
                    (x + 1) * CUBE_METRES,
                    (y + 1) * CUBE_METRES,
                    (z + 1) * CUBE_METRES);
        }
    }

    /**
     * Makes an empty cache.
     *
     * @param lights for each light but the sky the function from a box to the shaft
     */
    Shafts(TracedItems surfaces, List<Function<Aabb, ShaftShape>> lights) {
        this(surfaces, lights, MOST_BYTES);
    }

    /**
     * Makes an empty cache.
     *
     * @param mostBytes the limit on the memory of the shafts, beyond which all are dropped
     */
    Shafts(TracedItems surfaces, List<Function<Aabb, ShaftShape>> lights, long mostBytes) {
        this.mostBytes = mostBytes;
        this.surfaces = surfaces;
        this.lights = List.copyOf(lights);
    }

    /** Returns the number of the shafts in a direction of the sky; the numbers below belong to the lights. */
    int patch(Vector3dc direction) {
        double x = Math.abs(direction.x());
        double y = Math.abs(direction.y());
        double z = Math.abs(direction.z());
        if (x >= y && x >= z) {
            return patch(direction.x() < 0 ? 1 : 0, direction.y() / x, direction.z() / x);
        }
        return y >= z
                ? patch(direction.y() < 0 ? 3 : 2, direction.x() / y, direction.z() / y)
                : patch(direction.z() < 0 ? 5 : 4, direction.x() / z, direction.y() / z);
    }

    private int patch(int face, double s, double t) {
        int column = Math.min((int) ((s + 1) / 2 * SIDE), SIDE - 1);
        int row = Math.min((int) ((t + 1) / 2 * SIDE), SIDE - 1);
        return lights.size() + face * FACE_PATCHES + row * SIDE + column;
    }

    /**
     * Returns the cube around a position, or {@code null} if it is too far from the origin.
     *
     * @param likely returned if it is the right one; may be {@code null}
     */
    Cube cube(Vector3dc place, Cube likely) {
        int x = (int) Math.floor(place.x() / CUBE_METRES);
        int y = (int) Math.floor(place.y() / CUBE_METRES);
        int z = (int) Math.floor(place.z() / CUBE_METRES);
        return likely != null && likely.isAt(x, y, z) ? likely : cube(x, y, z);
    }

    private Cube cube(int x, int y, int z) {
        long farthest = Math.max(Math.abs((long) x), Math.max(Math.abs((long) y), Math.abs((long) z)));
        if (farthest > FARTHEST_METRES / CUBE_METRES) {
            return null;
        }
        Cube[] cubes = kept.cubes;
        int slot = (int) Hash64.combine(Hash64.combine(Hash64.combine(0, x), y), z) & MOST_CUBES - 1;
        Cube known = cubes[slot];
        if (known == null || !known.isAt(x, y, z)) {
            known = new Cube(x, y, z, lights.size() + 6 * FACE_PATCHES);
            cubes[slot] = known;
        }
        return known;
    }

    /**
     * Returns a shaft of a cube.
     *
     * @param number of a light, or of a {@link #patch}
     */
    Shaft shaft(Cube cube, int number) {
        Shaft known = cube.shafts[number];
        return known == null ? made(cube, number) : known;
    }

    private Shaft made(Cube cube, int number) {
        Shaft made = number < lights.size() ? toLight(cube, number) : intoSky(cube, number);
        if (kept.bytes.get() > mostBytes) {
            kept = new Kept();
        }
        return made;
    }

    private Shaft toLight(Cube cube, int number) {
        ShaftShape shape = lights.get(number).apply(cube.box());
        return keep(cube, number, surfaces.shaft(shape, surfaces.near(shape)));
    }

    /** Makes all patches of a face of the sky at once: items near one of them are near the face. */
    private Shaft intoSky(Cube cube, int number) {
        Aabb box = cube.box();
        int face = (number - lights.size()) / FACE_PATCHES;
        int first = lights.size() + face * FACE_PATCHES;
        int[] near = surfaces.near(ShaftShape.along(onCube(face, 0, 0), onCube(face, SIDE, SIDE), box));
        Shaft asked = null;
        for (int patch = 0; patch < FACE_PATCHES; patch++) {
            int column = patch % SIDE;
            int row = patch / SIDE;
            Vec3 least = onCube(face, column, row);
            Vec3 most = onCube(face, column + 1, row + 1);
            Shaft shaft = keep(cube, first + patch, surfaces.shaft(ShaftShape.along(least, most, box), near));
            asked = first + patch == number ? shaft : asked;
        }
        return asked;
    }

    private Shaft keep(Cube cube, int number, Shaft shaft) {
        cube.shafts[number] = shaft;
        kept.bytes.addAndGet(shaft.bytes());
        return shaft;
    }

    private static Vec3 onCube(int face, int column, int row) {
        double side = (face & 1) == 0 ? 1 : -1;
        double s = 2.0 * column / SIDE - 1;
        double t = 2.0 * row / SIDE - 1;
        return switch (face / 2) {
            case 0 -> new Vec3(side, s, t);
            case 1 -> new Vec3(s, side, t);
            default -> new Vec3(s, t, side);
        };
    }

    /** Tests shadow rays. Use one per thread. */
    static final class ShadowRays {
        /** The fraction of the distance to a place that is tested: the surface that the place is on does not hide it. */
        static final double BEFORE_END = 1 - 1e-9;

        private final TracedItems surfaces;
        private final Shafts shafts;
        private final Ray ray = Ray.reusable();
        private Shafts.Cube cube;

        ShadowRays(TracedItems surfaces, Shafts shafts) {
            this.surfaces = surfaces;
            this.shafts = shafts;
        }

        /**
         * Returns true if light is blocked.
         *
         * @param light number of the sun or of a punctual light in {@code direction}
         * @param limit parameter of the ray up to which items block it
         * @param lit the lit item: a convex item does not shade itself
         */
        boolean isBlocked(int light, Vector3dc origin, Vector3dc direction, double limit, int lit) {
            int except = surfaces.withoutOwnShade(lit);
            ray.aim(origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z());
            cube = shafts.cube(origin, cube);
            return cube == null
                    ? surfaces.blocker(ray, limit, except) >= 0
                    : shafts.shaft(cube, light).isBlocked(ray, limit, except);
        }

        /**
         * Returns true if anything is between a surface and a place at a distance in a unit direction. Without a shaft:
         * the paths of light come to too many cubes for one to be worth its making.
         */
        boolean isBlockedWithin(Vector3dc origin, Vector3dc direction, double metres, int lit) {
            ray.aim(origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z());
            return surfaces.blocker(ray, metres * BEFORE_END, surfaces.withoutOwnShade(lit)) >= 0;
        }

        /** Returns true if the sky is occluded in a direction. */
        boolean isSkyBlocked(Vector3dc origin, Vector3dc direction, int lit) {
            return isBlocked(shafts.patch(direction), origin, direction, Double.POSITIVE_INFINITY, lit);
        }
    }

    /** The items that the rays of a shaft may intersect. */
    static final class Shaft {
        /** The size of an object, its fields and the header of its list. */
        private static final int EMPTY_BYTES = 48;

        private final TracedItems surfaces;
        private final int[] items;
        /** The index of the item that blocked the last ray, tried first. Unsynchronised: it only affects speed. */
        private int likely;

        Shaft(TracedItems surfaces, int[] items) {
            this.surfaces = surfaces;
            this.items = items;
        }

        /** Returns the approximate size in memory. */
        long bytes() {
            return EMPTY_BYTES + (long) Integer.BYTES * items.length;
        }

        /**
         * Returns true if a ray of the shaft intersects any item except {@code except} up to the parameter {@code limit}.
         */
        boolean isBlocked(Ray ray, double limit, int except) {
            int first = likely;
            return isBlocked(ray, limit, except, first, items.length) || isBlocked(ray, limit, except, 0, first);
        }

        private boolean isBlocked(Ray ray, double limit, int except, int from, int to) {
            int i = surfaces.firstBox(ray, limit, items, from, to);
            while (i < to) {
                if (items[i] != except && surfaces.isBlockedBy(items[i], ray, limit)) {
                    likely = i;
                    return true;
                }
                i = surfaces.firstBox(ray, limit, items, i + 1, to);
            }
            return false;
        }
    }
}
