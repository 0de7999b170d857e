package nephele.lab.prove;

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

/** Hashes are equal in other processes, interpreted and compiled, on Java 17 and 25 where present. */
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
        assertEquals(60, assertSame(variant, JitMatrixProof.LEVEL, replay));
    }

    /** The two variants that differ most; {@code prove replay-hashes} plays the replay in all. */
    static Stream<JvmVariant> interpretedAndCompiled() {
        return variants()
                .filter(variant -> variant.flags().isEmpty() || variant.flags().contains("-Xint"));
    }

    /** A replay through 100 crossings and a portal that is shot again has equal hashes. */
    @ParameterizedTest
    @MethodSource("interpretedAndCompiled")
    void anotherProcessGoesThroughTheSamePortals(JvmVariant variant) throws Exception {
        assertSame(variant, JitMatrixProof.PORTALS_LEVEL, JitMatrixProof.throughPortals());
    }

    private int assertSame(JvmVariant variant, String level, Replay replay) throws Exception {
        Path file = Files.writeString(folder.resolve("replay.json"), replay.write());
        List<String> here = new ArrayList<>();
        var simulation = new Simulation(LevelFile.open(level).level(), replay.settings());
        replay.play(simulation, new TickHashes(EVERY, replay.ticks(), here::add));
        assertEquals(here, new ReplayProcess(variant, level, file, EVERY).lines());
        return here.size();
    }
}
