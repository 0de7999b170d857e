package nephele.host.playthrough;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import nephele.engine.level.Level;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.TickEvent;
import nephele.host.named.LevelCatalogue;
import nephele.host.named.LevelName;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The recordings of the campaign reach the exits and have the same hashes at every frame rate. */
@Execution(ExecutionMode.CONCURRENT)
class CampaignReplayTest {
    private static final int[] FRAMES_PER_SECOND = {10, 30, 144};

    /** A par is the number of portals of the recording, and its time with at most this much to spare. */
    private static final double PAR_SPARE_SECONDS = 10;

    static Stream<LevelName> campaign() {
        return LevelCatalogue.campaign().stream();
    }

    @ParameterizedTest
    @MethodSource("campaign")
    void everyFrameRateHasTheSameHashes(LevelName name) {
        var opened = name.open();
        var world = SimLevel.of(opened.placed());
        var replay = name.recordedWalk();
        List<Long> hashes = new ArrayList<>();
        var simulation = new Simulation(world, replay.settings());
        hashes.add(simulation.start().hash());
        replay.play(simulation, state -> hashes.add(state.hash()));
        for (int rate : FRAMES_PER_SECOND) {
            var beginning = new Playthrough.Beginning(name.fileName(), replay.settings(), replay.start());
            var playthrough = new Playthrough(opened.level(), world, beginning, new ReplayInput(replay));
            int frames = 0;
            int portals = 0;
            while (playthrough.state().tick() + 30 < replay.ticks()) {
                playthrough.advance(1_000_000_000L / rate);
                frames++;
                portals += (int) playthrough.takeEvents().stream()
                        .filter(TickEvent.PortalOpened.class::isInstance)
                        .count();
                int tick = (int) playthrough.state().tick();
                assertEquals(hashes.get(tick), playthrough.state().hash(), rate + " frames a second, tick " + tick);
            }
            assertEquals(0, playthrough.lostNanos());
            assertEquals(replay.ticks() / 120.0, frames / (double) rate, 0.5, rate + " frames a second");
            var exit = playthrough.state().world().exit();
            assertTrue(exit.isReached(), name.fileName());
            Level.Par par = opened.level().par();
            double spare = par.seconds() - exit.tick() / 120.0;
            assertTrue(spare >= 0 && spare <= PAR_SPARE_SECONDS, name.fileName() + ": " + spare);
            assertEquals(portals, par.portals(), name.fileName());
        }
    }
}
