package nephele.engine.cloud.drawn;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import nephele.engine.level.CloudTechnique;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class TechniqueFadeTest {
    private static final List<CloudTechnique> FAR = List.of(CloudTechnique.SKYBOX, CloudTechnique.SKYPLANE);
    private static final List<CloudTechnique> NEAR = List.of(CloudTechnique.PARTICLES, CloudTechnique.SKYPLANE);
    private static final List<CloudTechnique> INSIDE = List.of(CloudTechnique.VOLUME, CloudTechnique.VOLUME);
    private static final double FRAME = 1.0 / 60;

    private static double sum(TechniqueFade fade) {
        return IntStream.range(0, fade.stages().size())
                .mapToDouble(fade::fraction)
                .sum();
    }

    @Test
    void aChangeBeginsWithTheOldTechniquesAndEndsWithTheNewOnesAlone() {
        TechniqueFade begun = TechniqueFade.complete(FAR).towards(NEAR);
        TechniqueFade half = begun.after(TechniqueFade.SECONDS / 2);
        TechniqueFade ended = half.after(TechniqueFade.SECONDS / 2);
        assertAll(
                () -> assertTrue(TechniqueFade.complete(FAR).isComplete()),
                () -> assertEquals(
                        TechniqueFade.complete(FAR), TechniqueFade.complete(FAR).towards(FAR)),
                () -> assertEquals(1, begun.fraction(FAR)),
                () -> assertEquals(0, begun.fraction(NEAR)),
                () -> assertTrue(!half.isComplete() && half.fraction(NEAR) > 0.01 && half.fraction(FAR) > 0.05),
                () -> assertEquals(TechniqueFade.complete(NEAR), ended),
                () -> assertEquals(1, ended.fraction(NEAR)),
                () -> assertEquals(0, ended.fraction(FAR)),
                () -> assertEquals(ended, begun.after(Double.POSITIVE_INFINITY)));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void howeverOftenTheTargetChangesSharesAddUpToOneAndDoNotJump(long seed) {
        var random = new SplittableRandom(seed);
        List<List<CloudTechnique>> all = List.of(FAR, NEAR, INSIDE);
        TechniqueFade fade = TechniqueFade.complete(FAR);
        for (int frame = 0; frame < 600; frame++) {
            if (random.nextInt(12) == 0) {
                TechniqueFade before = fade;
                fade = fade.towards(all.get(random.nextInt(3)));
                for (List<CloudTechnique> one : all) {
                    assertEquals(before.fraction(one), fade.fraction(one), 1e-15);
                }
            }
            TechniqueFade before = fade;
            fade = fade.after(FRAME);
            assertEquals(1, sum(fade), 1e-12);
            for (List<CloudTechnique> one : all) {
                assertEquals(before.fraction(one), fade.fraction(one), 0.11);
            }
        }
        fade = fade.after(TechniqueFade.SECONDS);
        assertTrue(fade.isComplete());
        assertEquals(1, fade.fraction(fade.techniques()));
    }

    @Test
    void aChangeThatTurnsBackRetracesItsWay() {
        TechniqueFade there = TechniqueFade.complete(FAR).towards(NEAR).after(0.3);
        TechniqueFade back = there.after(0.2).towards(FAR).after(0.2);
        assertEquals(there.fraction(NEAR), back.fraction(NEAR), 1e-12);
        assertEquals(TechniqueFade.complete(FAR), back.after(0.31));
    }

    /** 1 − exp(−τ share) is what a pixel shows of the new techniques, over the old ones. */
    @ParameterizedTest
    @CsvSource({"0.01, 0.001", "0.1, 0.01", "1, 0.04", "3, 0.04", "10, 0.04", "30, 0.04", "100, 0.07"})
    void noPixelChangesMuchInAFrameWhateverItsDepth(double depth, double bound) {
        TechniqueFade fade = TechniqueFade.complete(FAR).towards(NEAR);
        double shown = 0;
        double most = 0;
        while (!fade.isComplete()) {
            fade = fade.after(FRAME);
            double now = -Math.expm1(-depth * fade.fraction(NEAR));
            most = Math.max(most, now - shown);
            assertTrue(now >= shown);
            shown = now;
        }
        assertEquals(0, most, bound);
    }
}
