package nephele.editor.draw;

import java.util.Arrays;

/** Line segments of a plan in pixels from its upper left corner; x and y of both ends of each. */
final class PlanSegments {
    static final int NUMBERS = 4;

    private float[] ends = new float[64 * NUMBERS];
    private int length;

    void add(double fromX, double fromY, double toX, double toY) {
        if (length == ends.length) {
            ends = Arrays.copyOf(ends, 2 * length);
        }
        ends[length] = (float) fromX;
        ends[length + 1] = (float) fromY;
        ends[length + 2] = (float) toX;
        ends[length + 3] = (float) toY;
        length += NUMBERS;
    }

    int count() {
        return length / NUMBERS;
    }

    /** Returns number 0 to 3 of a segment. */
    float end(int segment, int number) {
        return ends[segment * NUMBERS + number];
    }
}
