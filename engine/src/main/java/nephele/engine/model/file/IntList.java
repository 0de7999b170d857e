package nephele.engine.model.file;

import java.util.Arrays;

/** A growable list of integers. */
final class IntList {
    private int[] values = new int[48];
    private int size;

    int size() {
        return size;
    }

    int at(int i) {
        return values[i];
    }

    void add(int value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, 2 * size);
        }
        values[size++] = value;
    }

    int[] toArray() {
        return Arrays.copyOf(values, size);
    }
}
