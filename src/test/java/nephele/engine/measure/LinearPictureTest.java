package nephele.engine.measure;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

class LinearPictureTest {
    @Test
    void blocksBecomeTheirMeans() {
        float[] rgb = new float[3 * 4 * 2];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = i;
        }
        LinearPicture reduced = new LinearPicture(4, 2, rgb).reduced(2);
        assertEquals(2, reduced.width());
        assertEquals(1, reduced.height());
        // Pixels 0, 1, 4 and 5, then 2, 3, 6 and 7, of three values each.
        assertArrayEquals(new float[] {7.5f, 8.5f, 9.5f, 13.5f, 14.5f, 15.5f}, reduced.rgb());
    }

    @Test
    void brokenBlocksAreRefused() {
        var picture = new LinearPicture(3, 2, new float[18]);
        assertThrows(IllegalArgumentException.class, () -> picture.reduced(2));
    }
}
