package nephele.engine.math;

import java.util.Arrays;
import nephele.engine.math.bvh.RangeVisitor;

/** Runs of slots in the order of their calls; a run adjacent to the one before it is merged with it. */
public final class RangeList implements RangeVisitor {
    private int[] bounds = new int[32];
    private int size;
    private int slots;

    public void clear() {
        size = 0;
        slots = 0;
    }

    @Override
    public void range(int first, int end) {
        slots += end - first;
        if (size > 0 && bounds[2 * size - 1] == first) {
            bounds[2 * size - 1] = end;
            return;
        }
        if (size > 0 && bounds[2 * size - 2] == end) {
            bounds[2 * size - 2] = first;
            return;
        }
        if (2 * size == bounds.length) {
            bounds = Arrays.copyOf(bounds, size * 4);
        }
        bounds[2 * size] = first;
        bounds[2 * size + 1] = end;
        size++;
    }

    public int size() {
        return size;
    }

    /** Returns the number of slots in all runs. */
    public int slots() {
        return slots;
    }

    public int first(int run) {
        return bounds[2 * run];
    }

    /** Returns one past the last slot. */
    public int end(int run) {
        return bounds[2 * run + 1];
    }
}
