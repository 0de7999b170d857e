package nephele.lab.trade.subject;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.ByteBuffer;
import org.junit.jupiter.api.Test;

class DisplayedLightTest {
    /** Returns a picture four pixels wide of grey codes, each a little lighter in green and blue. */
    private static ByteBuffer picture(int... codes) {
        var rgba = ByteBuffer.allocate(4 * codes.length);
        for (int code : codes) {
            rgba.put((byte) code).put((byte) (code + 1)).put((byte) (code + 2)).put((byte) 255);
        }
        return rgba;
    }

    /** The light of an sRGB code (IEC 61966-2-1). */
    private static float light(int code) {
        double value = code / 255.0;
        return (float) (value <= 0.04045 ? value / 12.92 : Math.pow((value + 0.055) / 1.055, 2.4));
    }

    @Test
    void codesAreDecoded() {
        var light = Footage.displayedLight(picture(0, 10, 128, 253), 2, 2, 1);
        for (int i = 0; i < 12; i++) {
            assertEquals(light(new int[] {0, 10, 128, 253}[i / 3] + i % 3), light.rgb()[i], 1e-6);
        }
    }

    /** Black and white make 0.5 of the light, not of the code; boxes do not mix. */
    @Test
    void boxesAreAveragedInLinearLight() {
        var mean = Footage.displayedLight(picture(0, 0, 100, 200, 253, 253, 100, 200), 2, 1, 2);
        assertEquals(2, mean.width());
        assertEquals(1, mean.height());
        float[] expected = new float[6];
        for (int channel = 0; channel < 3; channel++) {
            expected[channel] = (light(channel) + light(253 + channel)) / 2;
            expected[3 + channel] = (light(100 + channel) + light(200 + channel)) / 2;
        }
        assertArrayEquals(expected, mean.rgb(), 1e-6f);
        assertEquals(0.5, mean.rgb()[2], 1e-3);
    }
}
