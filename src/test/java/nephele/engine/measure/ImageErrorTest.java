package nephele.engine.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class ImageErrorTest {
    private static final LinearPicture EXACT = new LinearPicture(2, 1, new float[] {1, 2, 4, 0, 0, 0});

    @Test
    void equalPicturesHaveNeither() {
        assertEquals(0, ImageError.relativeSquared(EXACT, EXACT));
        assertEquals(0, ImageError.meanBias(EXACT, EXACT));
        var black = new LinearPicture(1, 1, new float[3]);
        assertEquals(0, ImageError.meanBias(black, black));
    }

    /** For twice the light the squares are 1/(1 + 0.01), 4/4.01, 16/16.01 and three zeros; the bias is 1. */
    @Test
    void twiceTheLight() {
        var twice = new LinearPicture(2, 1, new float[] {2, 4, 8, 0, 0, 0});
        assertEquals((1 / 1.01 + 4 / 4.01 + 16 / 16.01) / 6, ImageError.relativeSquared(EXACT, twice), 1e-12);
        assertEquals(1, ImageError.meanBias(EXACT, twice), 1e-12);
    }

    /** Noise without bias keeps the mean but shows in the squared error: (0.1² + 0.1²) / 1.01 / 2. */
    @Test
    void noiseWithoutBias() {
        var even = new LinearPicture(2, 1, new float[] {1, 1, 1, 1, 1, 1});
        var noisy = new LinearPicture(2, 1, new float[] {1.1f, 1.1f, 1.1f, 0.9f, 0.9f, 0.9f});
        assertEquals(0.01 / 1.01, ImageError.relativeSquared(even, noisy), 1e-7);
        assertEquals(0, ImageError.meanBias(even, noisy), 1e-7);
    }

    /** The first pixel errs by 1, 2 and 2, the other by 8: √((1 + 4 + 4) / 3) alone. */
    @Test
    void onlyChosenPixelsCount() {
        var test = new LinearPicture(2, 1, new float[] {2, 4, 2, 8, 8, 8});
        assertEquals(Math.sqrt(3), ImageError.rootMeanSquare(EXACT, test, new boolean[] {true, false}), 1e-12);
        assertEquals(8, ImageError.rootMeanSquare(EXACT, test, new boolean[] {false, true}), 1e-12);
        assertEquals(0, ImageError.rootMeanSquare(EXACT, test, new boolean[2]));
    }
}
