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
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.TickEvent.Handled;
import nephele.engine.sim.state.TickEvent.Handled.Kind;
import nephele.engine.sim.state.TickEvent.PortalOpened;
import org.junit.jupiter.api.Test;

/**
 * The sample level of portals and its recorded game give the golden hashes: a cube is carried through the doors, a
 * hundred falls follow, and a portal is moved during a fall. A golden hash changes only when the rules of motion are
 * meant to change.
 */
class PortalsReplayTest {
    private static final Path SAMPLES = Path.of("levels", "samples");
    private final List<TickEvent> events = new ArrayList<>();
    private final List<String> hashes = new ArrayList<>();
    private int crossings;

    private SimState play() throws IOException {
        Level level = LevelJson.read("portals.json", Files.readAllBytes(SAMPLES.resolve("portals.json")));
        Replay replay = Replay.read("replays", Files.readAllBytes(SAMPLES.resolve("replays/portals.json")));
        var lines = Replay.hashes(600, replay.ticks(), hashes::add);
        return replay.play(new Simulation(level, replay.settings()), state -> {
            lines.accept(state);
            events.addAll(state.world().trace().events());
            crossings += state.world().trace().playerCrossed().length();
        });
    }

    @Test
    void itHasItsGoldenHashes() throws IOException {
        play();
        assertEquals(
                List.of(
                        "600 08afb68d65713cbc",
                        "1200 4b61b35f4d78936c",
                        "1800 71616dcbbad5fcfa",
                        "2400 428c094d9d2898cd",
                        "3000 a4baaddf1de80207",
                        "3434 7b885cf94c8da645"),
                hashes);
    }

    @Test
    void aHundredCrossingsAndAMovedPortal() throws IOException {
        SimState end = play();
        assertTrue(crossings > 100, crossings + " crossings");
        assertEquals(0, end.faults());
        assertEquals(
                List.of(
                        new Handled(Kind.PICKED_UP, 0),
                        new Handled(Kind.THROWN, 0),
                        new PortalOpened(GunPortals.Colour.FIRST, 2),
                        new PortalOpened(GunPortals.Colour.SECOND, 3),
                        new PortalOpened(GunPortals.Colour.SECOND, 3)),
                events);
        assertEquals(-7, end.world().portals().portal(3).centre().x(), 1e-9);
    }
}
