package nephele.host.playthrough;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.engine.level.Hint;
import nephele.engine.level.Language;
import nephele.engine.level.Level;
import nephele.engine.level.Place;
import nephele.engine.level.RecordCopy;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

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

    @ParameterizedTest
    @ValueSource(strings = {"02-first-shot", "03-momentum", "04-cube", "05-above-the-clouds", "06-standing-stones"})
    void theCampaignHelpsInThreeLanguagesEachHintLaterThanTheOneBefore(String name) throws IOException {
        Level level = LevelFile.read(Path.of("levels", name + ".json"));
        assertTrue(level.hints().size() >= 3, name);
        for (Hint hint : level.hints()) {
            assertEquals(Set.of(Language.values()), hint.text().keySet(), hint.id());
        }
        List<Hint> everywhere =
                level.hints().stream().filter(hint -> hint.near() == null).toList();
        for (int i = 1; i < everywhere.size(); i++) {
            assertTrue(everywhere.get(i).afterSeconds() > everywhere.get(i - 1).afterSeconds(), name);
        }
        assertEquals(
                LevelJson.sha256(level),
                LevelJson.sha256(RecordCopy.with(level, "landmark", null, "hints", List.of())),
                "replays go on");
    }

    @Test
    void noneIsGivenBeforeItsTime() {
        wait(0.9, Vec3.ZERO);
        assertNull(clock.offered());
        assertNull(clock.give(0));
        assertEquals(0, clock.given());
    }

    @Test
    void theTimeToTheNextOneIsThatOfPlayHere() {
        clock.tick(Vec3.ZERO);
        assertEquals(1 - 1 / 120.0, clock.secondsToNext(), 1e-9);
        wait(0.9, Vec3.ZERO);
        assertNull(clock.give(0.05));
        assertEquals(SOON, clock.give(0.1), "it is given shortly before its time");
        assertEquals(2 - 109 / 120.0, clock.secondsToNext(), 1e-9);
        wait(0.1, THERE);
        assertEquals(0.4, clock.secondsToNext(), 1e-9, "there the hint of the place comes first");
        clock.give(1);
        clock.give(9);
        assertEquals(3, clock.given());
        assertEquals(Double.POSITIVE_INFINITY, clock.secondsToNext());
    }

    @Test
    void theyAreGivenInTheLevelsOrderAndTheLastOneAgain() {
        wait(2.1, Vec3.ZERO);
        assertEquals(SOON, clock.give(0));
        assertEquals(LATER, clock.offered());
        assertEquals(LATER, clock.give(0));
        assertNull(clock.offered());
        assertEquals(LATER, clock.give(0), "a hint that was missed can be read again");
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
        assertEquals(SOON, clock.give(0), "who has gone on is not helped with what is behind");
    }
}
