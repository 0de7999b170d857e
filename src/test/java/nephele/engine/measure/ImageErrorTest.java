package nephele.engine.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.stream.IntStream;
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

    private static final int FRAMES = 5;

    private interface Light {
        double at(int frame, int pixel);
    }

    /** Returns frames of three by two pixels. */
    private static List<LinearPicture> frames(Light light) {
        return IntStream.range(0, FRAMES)
                .mapToObj(frame -> {
                    float[] rgb = new float[18];
                    for (int i = 0; i < rgb.length; i++) {
                        rgb[i] = (float) light.at(frame, i / 3);
                    }
                    return new LinearPicture(3, 2, rgb);
                })
                .toList();
    }

    @Test
    void aMovingPictureWithAConstantErrorDoesNotShimmer() {
        var reference = frames((frame, pixel) -> (frame + pixel) % 3 * 0.25);
        var test = frames((frame, pixel) -> (frame + pixel) % 3 * 0.25 + 0.125 * pixel);
        assertEquals(0, ImageError.shimmer(reference, test));
        assertEquals(0, ImageError.shimmer(reference, reference));
    }

    /** One pixel of six errs by +0.25 and −0.25 in turn: each change is 0.5, and √(0.5² / 6) is their RMS. */
    @Test
    void anAlternatingErrorHasTheRmsOfItsChange() {
        var reference = frames((frame, pixel) -> 0.5);
        var test = frames((frame, pixel) -> pixel == 4 ? 0.5 + (frame % 2 == 0 ? 0.25 : -0.25) : 0.5);
        assertEquals(0.5 / Math.sqrt(6), ImageError.shimmer(reference, test), 1e-12);
    }

    /** A still picture of a changing reference errs as much as a changing picture of a still reference. */
    @Test
    void aPictureThatDoesNotFollowShimmers() {
        var moving = frames((frame, pixel) -> 0.25 * frame);
        var still = frames((frame, pixel) -> 0);
        assertEquals(0.25, ImageError.shimmer(moving, still), 1e-12);
        assertEquals(0.25, ImageError.shimmer(still, moving), 1e-12);
    }

    @Test
    void framesOfOtherNumbersAreRefused() {
        var frames = frames((frame, pixel) -> 0);
        assertThrows(IllegalArgumentException.class, () -> ImageError.shimmer(frames, frames.subList(1, FRAMES)));
        assertThrows(
                IllegalArgumentException.class, () -> ImageError.shimmer(frames.subList(0, 1), frames.subList(0, 1)));
    }

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
        assertEquals(0, ImageError.overshoot(edge, edge, 6, 1));
        assertEquals(0, ImageError.overshoot(edge, greys(10, 10, 80, 120, 200, 200), 6, 1), "a softer edge");
        assertEquals(7, ImageError.overshoot(edge, greys(10, 10, 3, 204, 200, 200), 6, 1), "a halo on both sides");
        assertEquals(190, ImageError.overshoot(edge, greys(200, 10, 10, 200, 200, 200), 6, 1), "too far from the edge");
    }

    @Test
    void squaresReachOverRowsAndEndAtTheBorder() {
        assertEquals(0, ImageError.overshoot(greys(0, 0, 0, 90), greys(90, 90, 90, 0), 2, 1));
        assertEquals(90, ImageError.overshoot(greys(0, 0, 0, 90), greys(90, 0, 0, 0), 2, 0));
    }
}
