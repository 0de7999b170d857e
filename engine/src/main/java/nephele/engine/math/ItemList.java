package nephele.engine.math;

import java.util.Arrays;

/** A growing list of items that its owner clears and fills again without allocating. */
public final class ItemList implements ItemVisitor {
    private int[] items = new int[16];
    private int size;

    public void clear() {
        size = 0;
    }

    @Override
    public void item(int item) {
        if (size == items.length) {
            items = Arrays.copyOf(items, size * 2);
        }
        items[size++] = item;
    }

    public int size() {
        return size;
    }

    public int get(int index) {
        return items[index];
    }

    public int[] toArray() {
        return Arrays.copyOf(items, size);
    }

    /** Ascending order, so that what follows depends on no tree shape. */
    public void sort() {
        Arrays.sort(items, 0, size);
    }
}
