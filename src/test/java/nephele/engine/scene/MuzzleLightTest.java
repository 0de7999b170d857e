package nephele.engine.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.level.appearance.FlashStyle;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** The light of a shot comes at once, falls with time and distance, and ends. */
class MuzzleLightTest {
    private static final double TICK = 1.0 / 120;

    @Test
    void itIsBrightestAtTheShotAndGoneAfterASeventhOfASecond() {
        assertEquals(0, MuzzleLight.strengthAfter(-1e-9, FlashStyle.NATURAL));
        assertEquals(1, MuzzleLight.strengthAfter(0, FlashStyle.NATURAL));
        for (int tick = 1; tick < 17; tick++) {
            double before = MuzzleLight.strengthAfter((tick - 1) * TICK, FlashStyle.NATURAL);
            double now = MuzzleLight.strengthAfter(tick * TICK, FlashStyle.NATURAL);
            assertTrue(now < before, "tick " + tick + ": " + before + " to " + now);
        }
        assertEquals(0, MuzzleLight.strengthAfter(17 * TICK, FlashStyle.NATURAL));
    }

    @Test
    void softenedItRisesSlowlyAndStaysDim() {
        double last = 0;
        for (double seconds = 0; seconds < 0.5; seconds += 1 / 240.0) {
            double now = MuzzleLight.strengthAfter(seconds, FlashStyle.SOFTENED);
            assertTrue(now <= 0.3 && Math.abs(now - last) < 0.02, seconds + " s: " + last + " to " + now);
            last = now;
        }
        assertEquals(0, last);
    }

    @Test
    void itFallsWithTheSquareOfTheDistanceAndEndsAtItsRange() {
        var light = new MuzzleLight(Vec3.ZERO, 0, 1);
        assertEquals(4, light.displayed(1) / light.displayed(2), 0.7);
        assertEquals(0, light.displayed(MuzzleLight.RANGE_METRES));
        assertEquals(0, light.displayed(2 * MuzzleLight.RANGE_METRES));
        assertTrue(light.bounds().contains(0, MuzzleLight.RANGE_METRES, 0));
    }
}
