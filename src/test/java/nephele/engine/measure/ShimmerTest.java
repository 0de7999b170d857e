package nephele.engine.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class ShimmerTest {
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
        assertEquals(0, Shimmer.of(reference, test));
        assertEquals(0, Shimmer.of(reference, reference));
    }

    /** One pixel of six errs by +0.25 and −0.25 in turn: each change is 0.5, and √(0.5² / 6) is their RMS. */
    @Test
    void anAlternatingErrorHasTheRmsOfItsChange() {
        var reference = frames((frame, pixel) -> 0.5);
        var test = frames((frame, pixel) -> pixel == 4 ? 0.5 + (frame % 2 == 0 ? 0.25 : -0.25) : 0.5);
        assertEquals(0.5 / Math.sqrt(6), Shimmer.of(reference, test), 1e-12);
    }

    /** A still picture of a changing reference errs as much as a changing picture of a still reference. */
    @Test
    void aPictureThatDoesNotFollowShimmers() {
        var moving = frames((frame, pixel) -> 0.25 * frame);
        var still = frames((frame, pixel) -> 0);
        assertEquals(0.25, Shimmer.of(moving, still), 1e-12);
        assertEquals(0.25, Shimmer.of(still, moving), 1e-12);
    }

    @Test
    void framesOfOtherNumbersAreRefused() {
        var frames = frames((frame, pixel) -> 0);
        assertThrows(IllegalArgumentException.class, () -> Shimmer.of(frames, frames.subList(1, FRAMES)));
        assertThrows(IllegalArgumentException.class, () -> Shimmer.of(frames.subList(0, 1), frames.subList(0, 1)));
    }
}
