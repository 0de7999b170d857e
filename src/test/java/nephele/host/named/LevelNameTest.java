package nephele.host.named;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class LevelNameTest {
    @Test
    void titlesComeFromFileNames() {
        assertEquals("Courtyard", new LevelName("levels/01-courtyard.json").title());
        assertEquals("First light", new LevelName("C:\\levels\\12-first-light.json").title());
        assertEquals(".json", new LevelName(".json").title());
    }

    @Test
    void theFirstLevelIsNumberOne() {
        assertTrue(LevelCatalogue.first().fileName().startsWith("01-"));
    }

    @Test
    void aLevelWithoutAReplayStandsStill() {
        var walk = new LevelName("levels/samples/empty.json").recordedWalk();
        assertEquals(300, walk.ticks());
        assertEquals(1, walk.inputs().size());
    }

    @Test
    void theWalkOfLevelOneMoves() {
        assertTrue(LevelCatalogue.first().recordedWalk().inputs().size() > 1);
    }
}
