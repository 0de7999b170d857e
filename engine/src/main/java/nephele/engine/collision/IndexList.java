package nephele.engine.collision;

import java.util.Arrays;

/** A growing list of collider indices that is reused between queries. */
final class IndexList {
    private int[] indices = new int[64];
    private int size;

    void clear() {
        size = 0;
    }

    void add(int index) {
        if (size == indices.length) {
            indices = Arrays.copyOf(indices, 2 * size);
        }
        indices[size++] = index;
    }

    int size() {
        return size;
    }

    int get(int i) {
        return indices[i];
    }
}
