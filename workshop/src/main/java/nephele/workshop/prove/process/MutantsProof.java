package nephele.workshop.prove.process;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import nephele.host.terminal.CommandFailure;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Plants faults in copies of sources and shaders, and checks that a test fails. The jar holds neither sources nor
 * tests; therefore this calls the start script of the checkout, which calls Gradle.
 */
public final class MutantsProof implements Proof {
    private static final Path FRONT_DOOR = Path.of("nephele");

    @Override
    public Claim claim() {
        return new Claim(
                "mutants",
                "Every fault planted in culling, depth, blending, shadow, sRGB, light, collision, placement,"
                        + " simulation, level, model, cloud, sky, particle, terrain and plant code makes a test fail.",
                "mutants",
                117,
                13);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) throws Exception {
        if (!Files.isRegularFile(FRONT_DOOR) || !Files.isDirectory(Path.of("src", "test"))) {
            throw CommandFailure.environment(
                    "the proof `mutants` changes copies of the sources: run it in a checkout, with ./nephele prove"
                            + " mutants");
        }
        Process process = new ProcessBuilder("sh", FRONT_DOOR.toString(), "mutants", "-Pmutants=" + from + "," + count)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        List<String> survivors = new ArrayList<>();
        long judged = judge(process.inputReader(), survivors, progress);
        if (process.waitFor() != 0 || judged != count) {
            throw new IOException("Gradle judged " + judged + " of " + count + " mutants; its message stands above");
        }
        Figure killed = Figure.sum("killed", judged - survivors.size(), "");
        return ProofResult.of(judged, survivors, killed);
    }

    private static long judge(BufferedReader lines, List<String> survivors, Progress progress) throws IOException {
        long judged = 0;
        for (String line = lines.readLine(); line != null; line = lines.readLine()) {
            if (line.startsWith("SURVIVED | ")) {
                survivors.add(line);
            }
            if (line.startsWith("SURVIVED | ") || line.startsWith("killed | ")) {
                progress.unitsDone(++judged);
            }
        }
        return judged;
    }
}
