package nephele.engine.lightning;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.level.Environment.Lightning;
import nephele.engine.level.appearance.FlashStyle;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

class LevelLightningTest {
    private static final Lightning STORM =
            new Lightning(20, 7, new Vec3(100, 1500, -3000), new Vec3(2000, 600, 1500), 20, 0.7, new Vec3(1, 1, 1));
    private static final int STRIKES = 40;

    private final LevelLightning lightning = new LevelLightning(STORM);

    private double brightness(double seconds, FlashStyle style) {
        lightning.at(seconds, style);
        return lightning.brightness();
    }

    @Test
    void aStrikeIsAFunctionOfTheTimeWhateverWasAskedBefore() {
        LevelLightning other = new LevelLightning(STORM);
        for (int i = 0; i < 3000; i++) {
            other.at(0.04 * i, FlashStyle.NATURAL);
        }
        for (long strike : new long[] {5, 2, 31}) {
            double seconds = lightning.beginSeconds(strike) + 0.11;
            lightning.at(seconds, FlashStyle.NATURAL);
            other.at(seconds, FlashStyle.NATURAL);
            assertTrue(lightning.isLit());
            assertEquals(lightning.brightness(), other.brightness());
            assertEquals(lightning.bolt().points(), other.bolt().points());
            for (int i = 0; i < lightning.bolt().points(); i++) {
                assertEquals(lightning.bolt().get(i, 0), other.bolt().get(i, 0));
            }
        }
    }

    @Test
    void strikesEndBeforeTheNextOneBegins() {
        for (int strike = 0; strike < STRIKES; strike++) {
            double begin = lightning.beginSeconds(strike);
            assertTrue(begin + StrokeCurve.LONGEST_SECONDS <= lightning.beginSeconds(strike + 1) + 1e-9);
            assertEquals(0, brightness(begin, FlashStyle.NATURAL));
            assertEquals(0, brightness(begin + StrokeCurve.LONGEST_SECONDS, FlashStyle.NATURAL), 1e-12);
        }
        assertEquals(0, brightness(-1, FlashStyle.NATURAL));
    }

    @Test
    void strokesFollowWithinFourTenthsOfASecondAndDecay() {
        for (int strike = 0; strike < STRIKES; strike++) {
            double begin = lightning.beginSeconds(strike);
            double first = brightness(begin + StrokeCurve.EXPOSED_SECONDS, FlashStyle.NATURAL);
            assertTrue(first > 0.5 && first <= 1.01, () -> first + " of the first stroke");
            StrokeCurve strokes = lightning.strokes();
            assertTrue(strokes.strokes() >= 2 && strokes.strokes() <= 4);
            double last = strokes.beginSeconds(strokes.strokes() - 1);
            assertTrue(last >= 0.2 - 1e-9 && last <= 0.4 + 1e-9, () -> last + " s");
            double before = brightness(begin + last + StrokeCurve.EXPOSED_SECONDS, FlashStyle.NATURAL);
            for (double age = last + 0.03; age < StrokeCurve.LONGEST_SECONDS; age += 0.03) {
                double now = brightness(begin + age, FlashStyle.NATURAL);
                assertTrue(now < before, "decays");
                before = now;
            }
        }
        assertEquals(StrokeCurve.exposed(0.05, 0.04) * Math.exp(-0.1 / 0.04), StrokeCurve.exposed(0.15, 0.04), 1e-12);
    }

    /** No more than one rise, and no quick one: 3 % of full brightness in a frame. */
    @Test
    void softenedFlashesRiseSlowlyOnce() {
        double begin = lightning.beginSeconds(3);
        double before = 0;
        int rises = 0;
        boolean wasRising = false;
        for (double age = 0; age < StrokeCurve.LONGEST_SECONDS; age += 1.0 / 60) {
            double now = brightness(begin + age, FlashStyle.SOFTENED);
            boolean isRising = now > before;
            rises += isRising && !wasRising ? 1 : 0;
            assertTrue(now - before < 0.04 && now < 0.2);
            wasRising = isRising;
            before = now;
        }
        assertEquals(1, rises);
    }

    @Test
    void branchesBeginOnAChannelAndBoltsEndOnTheGroundOrInTheBox() {
        int onGround = 0;
        for (int strike = 0; strike < STRIKES; strike++) {
            lightning.at(lightning.beginSeconds(strike) + 0.01, FlashStyle.NATURAL);
            Bolt bolt = lightning.bolt();
            assertTrue(bolt.points() > 600 && bolt.points() <= Bolt.MOST_POINTS);
            for (int i = Bolt.MAIN_SEGMENTS + 1; i < bolt.points(); i++) {
                if (bolt.begins(i)) {
                    assertTrue(isBefore(bolt, i), "a branch begins at an earlier point");
                }
            }
            double end = bolt.origin().y() + bolt.get(Bolt.MAIN_SEGMENTS, 1);
            boolean strikesGround = Math.abs(end - 20) < 0.01;
            assertTrue(strikesGround || Math.abs(end - 1500) <= 300.01);
            onGround += strikesGround ? 1 : 0;
        }
        assertEquals(0.7 * STRIKES, onGround, 9);
        assertFalse(onGround == STRIKES);
    }

    private static boolean isBefore(Bolt bolt, int point) {
        for (int i = 0; i < point; i++) {
            if (bolt.get(i, 0) == bolt.get(point, 0)
                    && bolt.get(i, 1) == bolt.get(point, 1)
                    && bolt.get(i, 2) == bolt.get(point, 2)) {
                return true;
            }
        }
        return false;
    }

    /** Nobody can count the seconds to the next strike: times between two have a spread of the size of their mean. */
    @Test
    void strikesComeAtUnevenTimes() {
        double shortest = Double.POSITIVE_INFINITY;
        double longest = 0;
        for (int strike = 0; strike < STRIKES; strike++) {
            double between = lightning.beginSeconds(strike + 1) - lightning.beginSeconds(strike);
            shortest = Math.min(shortest, between);
            longest = Math.max(longest, between);
        }
        assertTrue(longest > 2 * shortest, shortest + " to " + longest + " s");
    }
}
