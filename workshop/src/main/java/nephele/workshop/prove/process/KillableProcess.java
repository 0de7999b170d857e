package nephele.workshop.prove.process;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** A Java process of this program that a proof kills. */
public final class KillableProcess implements AutoCloseable {
    private final Process process;

    private KillableProcess(Process process) {
        this.process = process;
    }

    /** Starts the main method of a class; what it writes to its error stream is discarded. */
    public static KillableProcess start(Class<?> main, String... arguments) throws IOException {
        ProcessBuilder process = process(main, arguments).redirectError(ProcessBuilder.Redirect.DISCARD);
        return new KillableProcess(process.start());
    }

    /** Starts the main method of a class; what it writes to its error stream is a part of its output. */
    public static KillableProcess startWithErrors(Class<?> main, String... arguments) throws IOException {
        return new KillableProcess(
                process(main, arguments).redirectErrorStream(true).start());
    }

    /** Returns a process that starts as cheaply as possible, with the class path of this one. */
    private static ProcessBuilder process(Class<?> main, String... arguments) {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+UseSerialGC",
                "-XX:TieredStopAtLevel=1",
                "-Xshare:auto",
                "-Xmx128m",
                "-cp",
                System.getProperty("java.class.path"),
                main.getName()));
        command.addAll(List.of(arguments));
        return new ProcessBuilder(command);
    }

    /** Returns what the process writes; what it wrote before a kill can be read after it. */
    public InputStream output() {
        return process.getInputStream();
    }

    /** Waits for the end of the process and returns its exit code. */
    public int waitFor() throws InterruptedException {
        return process.waitFor();
    }

    /** Kills the process and waits for its end. */
    public void kill() throws InterruptedException {
        // After Process.destroyForcibly the rest of the output can no longer be read; the handle leaves it readable.
        process.toHandle().destroyForcibly();
        process.waitFor();
    }

    /** Kills the process if it still runs, and closes its output. */
    @Override
    public void close() throws IOException {
        process.toHandle().destroyForcibly();
        process.getInputStream().close();
    }
}
