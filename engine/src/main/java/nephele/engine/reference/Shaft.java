package nephele.engine.reference;

import nephele.engine.math.Ray;

/** The items that the rays of a shaft may intersect. */
final class Shaft {
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
