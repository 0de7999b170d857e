package nephele.app;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/** The exit code and output of a program of this class path, run in its own process. */
public record ChildJvm(int exitCode, String out, String err) {
    private static final long LONGEST_SECONDS = 120;

    /**
     * Runs a program to its end.
     *
     * @param environment variables to set; an empty value removes one
     * @param words JVM options, main class, arguments
     */
    public static ChildJvm run(Path folder, Map<String, String> environment, String... words)
            throws IOException, InterruptedException {
        var command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                absoluteClassPath(),
                "-XX:TieredStopAtLevel=1", // it lives for seconds
                "-XX:+UseSerialGC",
                "-Djoml.nounsafe=true"));
        command.addAll(List.of(words));
        Path out = folder.resolve("child.out");
        Path err = folder.resolve("child.err");
        var builder = new ProcessBuilder(command)
                .directory(folder.toFile())
                .redirectOutput(out.toFile())
                .redirectError(err.toFile());
        environment.forEach((name, value) -> {
            if (value.isEmpty()) {
                builder.environment().remove(name);
            } else {
                builder.environment().put(name, value);
            }
        });
        var process = builder.start();
        if (!process.waitFor(LONGEST_SECONDS, TimeUnit.SECONDS)) {
            process.destroyForcibly();
            throw new IllegalStateException(command + " still runs after " + LONGEST_SECONDS + " s: " + read(err));
        }
        return new ChildJvm(process.exitValue(), read(out), read(err));
    }

    private static String absoluteClassPath() {
        var entries = new ArrayList<String>();
        for (var entry : System.getProperty("java.class.path").split(File.pathSeparator)) {
            entries.add(Path.of(entry).toAbsolutePath().toString());
        }
        return String.join(File.pathSeparator, entries);
    }

    private static String read(Path file) throws IOException {
        return Files.readString(file, StandardCharsets.UTF_8);
    }
}
