package nephele.lab.prove;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** {@code simulate} in a process of its own. */
public record ReplayProcess(JvmVariant variant, String level, Path replay, int every) {
    /** By name: the command line stands above the proofs. */
    private static final String MAIN = "nephele.app.Main";

    /**
     * The lines {@code tick hash} that it prints.
     *
     * @throws IOException with what it said when it fails
     */
    public List<String> lines() throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(variant.java().toString(), "-Xmx256m"));
        command.addAll(variant.flags());
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), MAIN));
        command.addAll(List.of("simulate", level, "--replay", replay.toString(), "--every", Integer.toString(every)));
        Path said = Files.createTempFile("nephele-simulate", ".txt");
        try {
            Process process =
                    new ProcessBuilder(command).redirectError(said.toFile()).start();
            process.getOutputStream().close();
            String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            if (process.waitFor() != 0) {
                throw new IOException(variant + ": " + Files.readString(said));
            }
            return text.lines().toList();
        } finally {
            Files.delete(said);
        }
    }
}
