package nephele.engine.model.file;

import java.util.Arrays;

/** A growable list of floats. */
final class FloatList {
    private float[] values = new float[48];
    private int size;

    int size() {
        return size;
    }

    float at(int i) {
        return values[i];
    }

    void add(double value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, 2 * size);
        }
        values[size++] = (float) value;
    }

    float[] toArray() {
        return Arrays.copyOf(values, size);
    }
}
