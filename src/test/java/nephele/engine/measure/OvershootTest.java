package nephele.engine.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.ByteBuffer;
import org.junit.jupiter.api.Test;

class OvershootTest {
    private static byte[] greys(int... values) {
        var bytes = ByteBuffer.allocate(4 * values.length);
        for (int value : values) {
            bytes.put((byte) value).put((byte) value).put((byte) value).put((byte) 255);
        }
        return bytes.array();
    }

    @Test
    void onlyWhatLeavesTheRangeAroundItCounts() {
        byte[] edge = greys(10, 10, 10, 200, 200, 200);
        assertEquals(0, Overshoot.codes(edge, edge, 6, 1));
        assertEquals(0, Overshoot.codes(edge, greys(10, 10, 80, 120, 200, 200), 6, 1), "a softer edge");
        assertEquals(7, Overshoot.codes(edge, greys(10, 10, 3, 204, 200, 200), 6, 1), "a halo on both sides");
        assertEquals(190, Overshoot.codes(edge, greys(200, 10, 10, 200, 200, 200), 6, 1), "too far from the edge");
    }

    @Test
    void squaresReachOverRowsAndEndAtTheBorder() {
        assertEquals(0, Overshoot.codes(greys(0, 0, 0, 90), greys(90, 90, 90, 0), 2, 1));
        assertEquals(90, Overshoot.codes(greys(0, 0, 0, 90), greys(90, 0, 0, 0), 2, 0));
    }
}
