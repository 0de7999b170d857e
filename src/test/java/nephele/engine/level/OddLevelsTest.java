package nephele.engine.level;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.LightMapLayout;
import nephele.engine.sim.FaultLog;
import nephele.engine.sim.PlayerInput;
import nephele.engine.sim.SimLevel;
import nephele.engine.sim.SimSettings;
import nephele.engine.sim.SimState;
import nephele.engine.sim.Simulation;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What is odd and accepted is told as a warning at most, and neither crashes nor hangs what is derived of it. */
class OddLevelsTest {
    private static final int TICKS = 10;
    private static final long MOST_CPU_NANOSECONDS = 10_000_000_000L;

    @TempDir
    static Path folder;

    @BeforeAll
    static void prepare() throws IOException {
        OddLevels.prepare(folder);
    }

    static Stream<BadLevel> levels() {
        return OddLevels.ALL.stream();
    }

    /** As many ticks as show whether each takes long. */
    @ParameterizedTest
    @MethodSource("levels")
    void isDerivedAndSimulatedSoon(BadLevel odd) {
        var threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = threads.getCurrentThreadCpuTime();
        Level level = LevelJson.read("odd.json", odd.content().get());
        AssetSource assets = LevelAssets.beside(folder.resolve("odd.json"));
        Scene scene = Scene.of(level, assets);
        LightMapLayout.of(StaticShapes.of(level, assets).solids());
        assertEquals(odd.path().isEmpty(), !scene.solids().isEmpty(), "draws nothing");
        var simulation = new Simulation(SimLevel.of(level, assets), SimSettings.DEFAULT, FaultLog.SILENT);
        SimState state = simulation.start();
        for (int tick = 0; tick < TICKS; tick++) {
            state = simulation.step(state, PlayerInput.NONE);
        }
        assertTrue(threads.getCurrentThreadCpuTime() - before < MOST_CPU_NANOSECONDS);
    }

    @ParameterizedTest
    @MethodSource("levels")
    void isAcceptedWithAWarningAtMost(BadLevel odd) throws IOException {
        Path file = Files.write(folder.resolve("odd.json"), odd.content().get());
        List<String> lines = LevelRules.check(LevelFile.read(file), LevelAssets.beside(file)).stream()
                .map(problem -> problem.line("odd.json"))
                .toList();
        assertEquals(odd.path().isEmpty() ? 0 : 1, lines.size(), lines::toString);
        assertTrue(
                lines.stream()
                        .allMatch(line -> line.startsWith("odd.json: " + odd.path() + ": warning: " + odd.words())),
                lines::toString);
    }
}
