package nephele.editor.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import nephele.editor.play.SolutionVerdict.Cause;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelJson;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.replay.ReplayRecorder;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** A solution recorded in a corridor with an exit at its end, replayed in edited corridors. */
@Execution(ExecutionMode.CONCURRENT)
class SolutionCheckTest {
    private static final String FLOOR = box("floor", "0, -0.5, -10", "6, 1, 40", "");
    private static final String END_WALL = box("end", "0, 3, -16", "6, 6, 1", ", \"portalable\": true");

    /** Too high to walk over, too low to hide the end wall from the player's eye. */
    private static final String BLOCK = box("block", "0, 0.6, -4", "6, 1.2, 0.5", "");

    private static String box(String id, String centre, String size, String more) {
        return "{\"id\": \"" + id + "\", \"kind\": \"box\", \"material\": \"m\", \"centre\": [" + centre
                + "], \"size\": [" + size + "]" + more + "}";
    }

    private static SimLevel corridor(String... solids) {
        return SimLevel.of(level(solids));
    }

    private static Level level(String... solids) {
        String text = "{\"format\": \"nephele-level\", \"version\": 1, \"player\": {\"feet\": [0, 0, 0]},"
                + " \"materials\": [{\"id\": \"m\"}], \"portalGun\": {},"
                + " \"exits\": [{\"id\": \"e\", \"feet\": [0, 0, -8], \"heightMetres\": 2}],"
                + " \"solids\": [" + String.join(",", solids) + "]}";
        return LevelJson.read("corridor.json", text.getBytes(StandardCharsets.UTF_8));
    }

    /** Returns a shot at the end wall and a walk to the exit. */
    private static Replay recorded() {
        var recorder = new ReplayRecorder("corridor.json", SimSettings.DEFAULT, null)
                .hold(PlayerInput.NONE, 0.2)
                .hold(PlayerInput.NONE.holding(Action.FIRE_FIRST), 0.1)
                .hold(PlayerInput.FORWARD, 2.5);
        var simulation = new Simulation(corridor(FLOOR, END_WALL), SimSettings.DEFAULT);
        var tracked = recorder.replay().tracked(simulation);
        return Replay.read("replay", tracked.write().getBytes(StandardCharsets.UTF_8));
    }

    private static SolutionVerdict verdict(String... solids) {
        return SolutionCheck.of(corridor(solids), recorded(), progress -> {});
    }

    @Test
    void inTheLevelAsRecordedItIsSolvedWithoutADeviation() {
        var verdict = verdict(FLOOR, END_WALL);
        assertTrue(verdict.isSolved());
        assertEquals(1, verdict.exit().orElseThrow().portals());
        assertEquals(2.1, verdict.exit().orElseThrow().seconds(), 0.4);
        assertTrue(verdict.deviation().isEmpty());
    }

    @Test
    void aWallInTheWayIsFoundWithItsPlaceAndTime() {
        var verdict = verdict(FLOOR, END_WALL, BLOCK);
        var deviation = verdict.deviation().orElseThrow();
        assertFalse(verdict.isSolved());
        assertEquals(Cause.ELSEWHERE, deviation.cause());
        assertEquals(1.4, deviation.seconds(), 0.3);
        assertEquals(-3.45, deviation.place().z(), 0.02);
        assertTrue(deviation.expected().z() < deviation.place().z() - 0.01);
        assertTrue(PlayText.of(verdict).english().startsWith("Not solved; first astray at tick 1"));
    }

    @Test
    void aPortalThatIsRefusedIsFoundThoughTheExitIsReached() {
        var verdict = verdict(FLOOR, END_WALL.replace("true", "false"));
        assertTrue(verdict.isSolved());
        assertEquals(0, verdict.exit().orElseThrow().portals());
        assertEquals(Cause.PORTAL_REFUSED, verdict.deviation().orElseThrow().cause());
        assertEquals(0.2, verdict.deviation().orElseThrow().seconds(), 0.05);
    }

    @Test
    void ofARecordingWithoutATrackOnlyTheExitCounts() {
        var recorded = recorded();
        var old = new Replay("corridor.json", recorded.settings(), null, recorded.inputs());
        var blocked = corridor(FLOOR, END_WALL, BLOCK);
        var verdict = SolutionCheck.of(blocked, old, progress -> {});
        assertEquals(Cause.EXIT_NOT_REACHED, verdict.deviation().orElseThrow().cause());
        assertTrue(SolutionCheck.of(corridor(FLOOR, END_WALL), old, progress -> {})
                .deviation()
                .isEmpty());
    }

    @Test
    void theTrackListsRegularPlacesAndThePortal() {
        var track = recorded().track();
        assertTrue(track.size() >= 11, track.toString());
        assertEquals(
                1, track.stream().filter(point -> !point.opened().isEmpty()).count());
    }

    @Test
    void aCheckEndsWhenItsProgressSaysSo() {
        assertThrows(
                CancellationException.class,
                () -> SolutionCheck.of(corridor(FLOOR), recorded(), progress -> {
                    throw new CancellationException();
                }));
    }

    @Test
    void theSolutionBesideALevelIsCheckedInTheBackground(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("corridor.json");
        var missing = new CompletableFuture<String>();
        var received = new CompletableFuture<SolutionVerdict>();
        SolutionCheck.start(
                file,
                task -> new Thread(task).start(),
                () -> corridor(FLOOR),
                progress -> {},
                received::complete,
                missing::complete);
        assertTrue(missing.get(20, TimeUnit.SECONDS).contains("no recorded solution"));
        Path solution = SolutionCheck.fileOf(file);
        assertEquals(folder.resolve("replays").resolve("corridor.json"), solution);
        Files.createDirectories(solution.getParent());
        Files.writeString(solution, recorded().write());
        SolutionCheck.start(
                file,
                task -> new Thread(task).start(),
                () -> corridor(FLOOR, END_WALL),
                progress -> {},
                received::complete,
                missing::complete);
        assertTrue(received.get(20, TimeUnit.SECONDS).isSolved());
    }

    @Test
    void aCancelledCheckTellsNothing(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("corridor.json");
        Files.createDirectories(SolutionCheck.fileOf(file).getParent());
        Files.writeString(SolutionCheck.fileOf(file), recorded().write());
        var received = new CopyOnWriteArrayList<Object>();
        var mayGoOn = new CountDownLatch(1);
        var simulated = new CompletableFuture<Thread>();
        Runnable cancel = SolutionCheck.start(
                file,
                task -> new Thread(task).start(),
                () -> {
                    simulated.complete(Thread.currentThread());
                    await(mayGoOn);
                    return corridor(FLOOR, END_WALL);
                },
                progress -> {},
                received::add,
                received::add);
        Thread thread = simulated.get(20, TimeUnit.SECONDS);
        cancel.run();
        mayGoOn.countDown();
        thread.join();
        assertEquals(List.of(), received);
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException interrupted) {
            throw new IllegalStateException(interrupted);
        }
    }
}
