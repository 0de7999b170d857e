package nephele.engine.reference;

import nephele.engine.math.Ray;

/** All that rays of light which run close to each other may meet. */
final class Beam {
    /** Of an object, its fields and the head of its list. */
    private static final int EMPTY_BYTES = 48;

    private final SurfaceRays surfaces;
    private final int[] items;
    /** Index of what last shaded a place, which likely shades the next one. Threads may overwrite it as they like. */
    private int likely;

    Beam(SurfaceRays surfaces, int[] items) {
        this.surfaces = surfaces;
        this.items = items;
    }

    /** Of memory, about. */
    long bytes() {
        return EMPTY_BYTES + (long) Integer.BYTES * items.length;
    }

    /** Whether a ray of the beam meets any item but {@code except} up to the parameter {@code limit}. */
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
