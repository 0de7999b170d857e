package nephele.workshop.art;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFile;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.SimState;
import org.junit.jupiter.api.Test;

/** The recorded walk of level 01 still leads from the hall to the board above the court. */
class LevelOneReplayTest {
    @Test
    void walkEndsOnTheGallery() throws IOException {
        Level level = LevelFile.load(Path.of("levels/01-courtyard.json")).level();
        Path file = Path.of("levels/replays/01-courtyard.json");
        Replay walk = Replay.read(file.toString(), Files.readAllBytes(file));
        SimState end = walk.play(new Simulation(level, walk.settings()), state -> {});
        assertEquals(3.6, end.player().feet().y(), 0.05);
        assertEquals(0, end.player().feet().x(), 0.5);
        assertEquals(0, end.faults());
        assertTrue(walk.ticks() >= 20 * 120 && walk.ticks() <= 35 * 120, walk.ticks() + " ticks");
    }
}
