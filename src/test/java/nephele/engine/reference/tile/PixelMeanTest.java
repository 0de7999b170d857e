package nephele.engine.reference.tile;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.SplittableRandom;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PixelMeanTest {
    /** Independent samples of variance s² have a mean of variance s² / n, however n is divided into batches. */
    @ParameterizedTest
    @ValueSource(ints = {32, 33, 50, 63, 64, 1000})
    void theVarianceOfTheMeanIsThatOfASampleDividedByTheirNumber(int samples) {
        var random = new SplittableRandom(samples);
        PixelMean mean = new PixelMean(samples);
        int pixels = 4000;
        double variances = 0;
        double means = 0;
        float[] values = new float[3];
        for (int pixel = 0; pixel < pixels; pixel++) {
            mean.reset();
            for (int i = 0; i < samples; i++) {
                mean.add(new Vector3d(random.nextDouble(), 0, 7));
            }
            mean.putVariance(values, 0);
            variances += values[0];
            assertEquals(0, values[1] + values[2], 1e-20);
            mean.putMean(values, 0);
            means += values[0];
            assertEquals(7, values[2], 1e-5);
        }
        // A sum of 31 squares has a relative deviation of √(2/31) = 0.25, the mean of 4000 of them one of 0.004.
        assertEquals(1, variances / pixels * 12 * samples, 0.016);
        assertEquals(0.5, means / pixels, 4 * Math.sqrt(1.0 / 12 / samples / pixels));
    }

    @Test
    void fewSamplesHaveNoVariance() {
        assertFalse(new PixelMean(31).hasVariance());
    }

    /** Each value of the error has the mean variance of the 5 × 5 pixels around it that are in the picture. */
    @Test
    void theErrorIsSmoothedOverFiveByFivePixels() {
        PixelTiles tiles = new PixelTiles(20, 18);
        TiledPicture picture = new TiledPicture(tiles);
        for (int tile = 0; tile < tiles.count(); tile++) {
            float[] variance = new float[3 * tiles.pixels(tile)];
            if (tile == 0) {
                variance[0] = 900; // the lower left corner, red
                variance[3 * (10 * 16 + 10) + 1] = 100; // in the middle, green
            }
            picture.put(new TilePixels(tile, new float[variance.length], variance));
        }
        float[] error = picture.standardError();
        assertEquals(Math.sqrt(900 / 9.0), error[0], 1e-5);
        assertEquals(Math.sqrt(900 / 12.0), error[3], 1e-5);
        assertEquals(Math.sqrt(900 / 25.0), error[3 * (2 * 20 + 2)], 1e-5);
        assertEquals(0, error[3 * (3 * 20 + 2)]);
        assertEquals(2, error[3 * (12 * 20 + 8) + 1], 1e-5);
        assertEquals(0, error[3 * (13 * 20 + 8) + 1]);
    }
}
