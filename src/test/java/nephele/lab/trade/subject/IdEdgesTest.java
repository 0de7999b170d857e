package nephele.lab.trade.subject;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.ByteBuffer;
import org.junit.jupiter.api.Test;

class IdEdgesTest {
    /** Marks the pixels with another one beside or diagonally, and none across the picture's border. */
    @Test
    void pixelsBesideAnotherSurfaceAreNear() {
        int[] rows = {
            1, 1, 1, 1, 1,
            1, 2, 1, 1, 1,
            1, 1, 1, 1, 1,
            1, 1, 1, 1, 3,
        };
        var rgba = ByteBuffer.allocate(4 * rows.length);
        for (int id : rows) {
            rgba.putInt(id);
        }
        var marks = new StringBuilder();
        for (boolean near : EdgeExperiment.nearEdges(rgba, 5, 4)) {
            marks.append(near ? '#' : '.');
        }
        assertEquals("###.." + "###.." + "#####" + "...##", marks.toString());
    }
}
