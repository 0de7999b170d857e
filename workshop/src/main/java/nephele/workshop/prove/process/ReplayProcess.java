package nephele.workshop.prove.process;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.SimLevel;
import nephele.host.named.LevelName;

/** A replay played in a process of its own. */
public record ReplayProcess(JvmVariant variant, String level, Path replay, int every) {
    /**
     * Prints a line {@code tick hash} every so many ticks.
     *
     * @param arguments level, replay, ticks between two lines
     */
    public static void main(String[] arguments) {
        var opened = new LevelName(arguments[0]).open();
        var replay = LevelName.replay(arguments[1]);
        var level = SimLevel.of(opened.placed());
        var hashes = Replay.hashes(Integer.parseInt(arguments[2]), replay.ticks(), System.out::println);
        replay.play(new Simulation(level, replay.settings()), hashes);
    }

    /**
     * Runs the process and returns the lines {@code tick hash} that it prints.
     *
     * @throws IOException with the error output of the process if it fails
     */
    public List<String> lines() throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(variant.java().toString(), "-Xmx256m"));
        command.addAll(variant.flags());
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), ReplayProcess.class.getName()));
        command.addAll(List.of(level, replay.toString(), Integer.toString(every)));
        Path said = Files.createTempFile("nephele-replay", ".txt");
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
