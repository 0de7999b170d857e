package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Vec3;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimSettings;
import org.junit.jupiter.api.Test;

/**
 * The sample level of walking and its recorded walk give the golden hashes. They change only when the rules of motion
 * are meant to change; the new lines are then those that the failure shows.
 */
class WalkingReplayTest {
    private static final Path SAMPLES = Path.of("levels", "samples");

    private static Level level() throws IOException {
        return LevelJson.read("walking.json", Files.readAllBytes(SAMPLES.resolve("walking.json")));
    }

    private static Replay replay() throws IOException {
        return Replay.read("replays/walking.json", Files.readAllBytes(SAMPLES.resolve("replays/walking.json")));
    }

    private static List<String> hashes(Replay replay, int every) throws IOException {
        List<String> lines = new ArrayList<>();
        replay.play(new Simulation(level(), replay.settings()), Replay.hashes(every, replay.ticks(), lines::add));
        return lines;
    }

    @Test
    void theWalkHasItsGoldenHashes() throws IOException {
        assertEquals(
                List.of(
                        "475 8cefbd4ba0294262",
                        "950 2d29133cbb622dc2",
                        "1425 ef3fb3815d412e53",
                        "1900 87075596afeef977",
                        "2375 6a947f5a5a601ee8",
                        "2850 ad6f0c07b8f55c91"),
                hashes(replay(), 475));
    }

    @Test
    void anyTickRateHasItsGoldenHash() throws IOException {
        Replay recorded = replay();
        List<String> last = new ArrayList<>();
        for (int rate : new int[] {30, 60, 240}) {
            Replay changed =
                    new Replay(recorded.level(), SimSettings.DEFAULT.withTicksPerSecond(rate), null, recorded.inputs());
            List<String> lines = hashes(changed, Integer.MAX_VALUE);
            last.add(lines.get(0));
        }
        assertEquals(List.of("2850 202c36d4647a2a9a", "2850 b8b7f982fa6ea5a2", "2850 7ee5dd8fbd69754c"), last);
    }

    @Test
    void theWalkPassesEveryStation() throws IOException {
        List<Vec3> feet = new ArrayList<>();
        List<PlayerState> states = new ArrayList<>();
        replay().play(new Simulation(level(), SimSettings.DEFAULT), state -> {
            states.add(state.player());
            feet.add(state.player().feet());
        });
        assertTrue(feet.stream().anyMatch(f -> f.y() > 1.59 && f.z() < -4.5), "on the stairs");
        assertTrue(states.stream().anyMatch(s -> s.stance() == PlayerDimensions.Stance.CROUCHED), "under the beam");
        assertTrue(feet.stream().anyMatch(f -> Math.abs(f.x()) < 0.04 && f.z() < -15), "in the slot");
        assertTrue(feet.stream().anyMatch(f -> Math.abs(f.y() - 0.9) < 1e-6 && f.z() < -19), "on the crate");
        assertTrue(feet.stream().anyMatch(f -> f.y() > 3), "up the slope");
    }

    @Test
    void playingTwiceIsPlayingTheSame() throws IOException {
        assertEquals(hashes(replay(), 1), hashes(replay(), 1));
    }
}
