package nephele.engine.playthrough;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.util.List;
import java.util.Map;
import nephele.engine.level.Hint;
import nephele.engine.level.Language;
import nephele.engine.level.Place;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** Hints are offered after their time near their place, given one at a time in the level's order, and counted. */
class HintClockTest {
    private static final Vec3 THERE = new Vec3(10, 0, 0);
    private static final Hint SOON = hint("soon", 1, null);
    private static final Hint LATER = hint("later", 2, null);
    private static final Hint NEAR = hint("near", 0.5, new Place(THERE, 2));

    private final HintClock clock = new HintClock(List.of(SOON, LATER, NEAR), 1 / 120.0);

    private static Hint hint(String id, double seconds, Place near) {
        return new Hint(id, Map.of(Language.EN, id), seconds, near);
    }

    private void wait(double seconds, Vec3 at) {
        for (int i = 0; i < seconds * 120; i++) {
            clock.tick(at);
        }
    }

    @Test
    void noneIsGivenBeforeItsTime() {
        wait(0.9, Vec3.ZERO);
        assertNull(clock.offered());
        assertNull(clock.give());
        assertEquals(0, clock.given());
    }

    @Test
    void theyAreGivenInTheLevelsOrderAndTheLastOneAgain() {
        wait(2.1, Vec3.ZERO);
        assertEquals(SOON, clock.give());
        assertEquals(LATER, clock.offered());
        assertEquals(LATER, clock.give());
        assertNull(clock.offered());
        assertEquals(LATER, clock.give(), "a hint that was missed can be read again");
        assertEquals(2, clock.given());
    }

    @Test
    void aHintOfAPlaceCountsThereAndIsOfferedOnlyThere() {
        wait(0.3, THERE);
        wait(0.2, Vec3.ZERO);
        assertNull(clock.offered());
        wait(0.3, THERE.plus(new Vec3(0, 0, 1.9)));
        assertEquals(NEAR, clock.offered());
        wait(0.3, THERE.plus(new Vec3(0, 0, 2.1)));
        assertEquals(SOON, clock.give(), "who has gone on is not helped with what is behind");
    }
}
