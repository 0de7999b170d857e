package nephele.workshop.prove;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.json.LevelFile;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.replay.Replay;
import nephele.workshop.prove.process.JitMatrixProof;
import nephele.workshop.prove.process.JvmVariant;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/**
 * Hashes are equal in other processes. The suite plays in the two variants that differ most from its own process: one
 * interpreted, one with another language and time zone on another Java if there is one. {@code prove replay-hashes} plays
 * in all.
 */
@Execution(ExecutionMode.CONCURRENT)
class JitMatrixReplayTest {
    private static final int EVERY = 10;

    @TempDir
    Path folder;

    private static JvmVariant interpreted() {
        return JvmVariant.all().stream()
                .filter(variant -> variant.flags().contains("-Xint"))
                .findFirst()
                .orElseThrow();
    }

    private static JvmVariant farthestAway() {
        List<JvmVariant> all = JvmVariant.all();
        JvmVariant last = all.get(all.size() - 1);
        assertTrue(last.flags().contains("-Duser.language=tr"), last.name());
        return last;
    }

    @Test
    void otherProcessesPlayTheSame() throws Exception {
        Replay replay = JitMatrixProof.wandering(1, 600);
        assertEquals(60, assertSame(List.of(interpreted(), farthestAway()), JitMatrixProof.LEVEL, replay));
    }

    /** A replay through 100 crossings and a portal that is shot again has equal hashes. */
    @Test
    void anotherProcessGoesThroughTheSamePortals() throws Exception {
        assertSame(List.of(farthestAway()), JitMatrixProof.PORTALS_LEVEL, JitMatrixProof.throughPortals());
    }

    private int assertSame(List<JvmVariant> variants, String level, Replay replay) throws Exception {
        Path file = Files.writeString(folder.resolve("replay.json"), replay.write());
        List<String> here = new ArrayList<>();
        var simulation = new Simulation(LevelFile.open(level).level(), replay.settings());
        replay.play(simulation, Replay.hashes(EVERY, replay.ticks(), here::add));
        for (JvmVariant variant : variants) {
            assertEquals(here, JitMatrixProof.hashesOfProcess(variant, level, file, EVERY), variant.name());
        }
        return here.size();
    }
}
