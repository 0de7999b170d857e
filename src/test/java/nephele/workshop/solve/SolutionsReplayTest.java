package nephele.workshop.solve;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** The levels after the first are solved by their recordings, and not by the same input without shots. */
@Execution(ExecutionMode.CONCURRENT)
class SolutionsReplayTest {
    private static final Path LEVELS = Path.of("levels");
    private static final Path REPLAYS = LEVELS.resolve("replays");

    static Stream<Solution> solutions() {
        return Solution.ALL.stream();
    }

    private static PlacedLevel level(Solution solution) {
        LevelFile.Opened opened = LevelFile.load(LEVELS.resolve(solution.levelFile()));
        return PlacedLevel.of(opened.level(), opened.assets());
    }

    private static Replay recorded(Solution solution) throws IOException {
        Path file = REPLAYS.resolve(solution.levelFile());
        return Replay.read(file.toString(), Files.readAllBytes(file));
    }

    private static Simulation simulation(PlacedLevel level, SimSettings settings) {
        return new Simulation(SimLevel.of(level), settings);
    }

    private static SimState play(Replay replay, PlacedLevel level) {
        return replay.play(simulation(level, replay.settings()), state -> {});
    }

    /** Returns the inputs of a replay without some actions. */
    private static Replay without(Set<Action> actions, Replay replay) {
        List<Replay.Run> rest = replay.inputs().stream()
                .map(run -> new Replay.Run(
                        run.ticks(),
                        run.forwardPercent(),
                        run.rightPercent(),
                        run.turnLeftMillidegrees(),
                        run.turnUpMillidegrees(),
                        run.hold().stream()
                                .filter(action -> !actions.contains(action))
                                .toList()))
                .toList();
        return new Replay(replay.level(), replay.settings(), replay.start(), rest);
    }

    @ParameterizedTest
    @MethodSource("solutions")
    void recordingSolvesTheLevel(Solution solution) throws IOException {
        Replay replay = recorded(solution);
        SimState end = play(replay, level(solution));
        assertTrue(solution.isSolvedBy(end.player()), "ends at " + end.player().feet());
        assertEquals(0, end.faults());
        assertTrue(replay.ticks() <= 80 * 120, replay.ticks() + " ticks");
    }

    @ParameterizedTest
    @MethodSource("solutions")
    void theSameWalkWithoutAShotNeverReachesTheGoal(Solution solution) throws IOException {
        Replay walk = without(Set.of(Action.FIRE_FIRST, Action.FIRE_SECOND), recorded(solution));
        walk.play(
                simulation(level(solution), walk.settings()),
                state -> assertFalse(solution.isSolvedBy(state.player()), "tick " + state.tick()));
    }

    /** The file equals what the code plays; {@code gradle solutions} writes it again. */
    @ParameterizedTest
    @MethodSource("solutions")
    void recordingIsWhatTheCodePlays(Solution solution) throws IOException {
        assertEquals(solution.playIn(level(solution)).write(), Files.readString(REPLAYS.resolve(solution.levelFile())));
    }

    /** A golden hash may change only when the level, its solution or the rules of motion change intentionally. */
    @ParameterizedTest
    @CsvSource({
        "0, 87d9198da0e23717",
        "1, 8be89304f10373dc",
        "2, 2aa614ebac003152",
        "3, d585661db02fd8de",
        "4, a46968574446896f"
    })
    void recordingEndsInItsGoldenState(int index, String hash) throws IOException {
        Solution solution = Solution.ALL.get(index);
        assertEquals(
                hash, Long.toHexString(play(recorded(solution), level(solution)).hash()));
    }

    /** Level 04 needs the crate in the garden, in front of the terrace, and not only a way in. */
    @Test
    void withoutTheCrateTheTerraceIsTooHigh() throws IOException {
        Solution solution = Solution.ALL.get(2);
        PlacedLevel level = level(solution);
        Vec3 crate = play(recorded(solution), level).world().bodies().state(0).centre();
        assertEquals(0.3, crate.y(), 0.01);
        assertTrue(crate.z() < -2.6 && crate.x() < 2.5 && crate.x() > 1.9, crate.toString());
        without(Set.of(Action.CARRY), recorded(solution)).play(simulation(level, SimSettings.DEFAULT), state -> {
            assertFalse(solution.isSolvedBy(state.player()));
            assertTrue(state.player().feet().y() < 1.2, "tick " + state.tick());
        });
    }

    @Test
    void everyLevelAfterTheFirstHasASolution() throws IOException {
        Set<String> levels = new TreeSet<>();
        try (Stream<Path> files = Files.list(LEVELS)) {
            files.map(file -> file.getFileName().toString())
                    .filter(name -> name.matches("[0-9]{2}-.*\\.json") && !name.startsWith("01"))
                    .forEach(levels::add);
        }
        assertEquals(
                levels,
                new TreeSet<>(Solution.ALL.stream().map(Solution::levelFile).toList()));
    }
}
