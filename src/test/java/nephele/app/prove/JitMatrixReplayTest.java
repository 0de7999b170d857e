package nephele.app.prove;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import nephele.engine.level.LevelFile;
import nephele.engine.sim.Replay;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.TickHashes;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Issue 2: hashes equal in other processes, interpreted and compiled, on Java 17 and 25 where present. */
class JitMatrixReplayTest {
    private static final int EVERY = 10;

    @TempDir
    Path folder;

    static Stream<JvmVariant> variants() {
        return JvmVariant.all().stream();
    }

    @ParameterizedTest
    @MethodSource("variants")
    void anotherProcessPlaysTheSame(JvmVariant variant) throws Exception {
        Replay replay = JitMatrixProof.wandering(1, 600);
        Path file = Files.writeString(folder.resolve("wandering.json"), replay.write());
        List<String> here = new ArrayList<>();
        var simulation = new Simulation(LevelFile.open(JitMatrixProof.LEVEL).level(), replay.settings());
        replay.play(simulation, new TickHashes(EVERY, replay.ticks(), here::add));
        assertEquals(60, here.size());
        assertEquals(here, new ReplayProcess(variant, JitMatrixProof.LEVEL, file, EVERY).lines());
    }
}
