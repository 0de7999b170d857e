package nephele.engine.math.bvh;

import java.util.Arrays;
import java.util.function.IntConsumer;

/** A growable list of items that can be cleared and refilled without allocating. */
public final class ItemList implements IntConsumer {
    private int[] items = new int[16];
    private int size;

    public void clear() {
        size = 0;
    }

    @Override
    public void accept(int item) {
        if (size == items.length) {
            items = Arrays.copyOf(items, size * 2);
        }
        items[size++] = item;
    }

    /** Returns the number of items. */
    public int size() {
        return size;
    }

    /** Returns the item at an index from 0 to {@link #size} − 1. */
    public int get(int index) {
        return items[index];
    }

    /** Returns a copy of the items. */
    public int[] toArray() {
        return Arrays.copyOf(items, size);
    }

    /** Sorts the items in ascending order, so that later results do not depend on the shape of the tree. */
    public void sort() {
        Arrays.sort(items, 0, size);
    }
}
