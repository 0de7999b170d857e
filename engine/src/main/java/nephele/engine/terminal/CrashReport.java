package nephele.engine.terminal;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;

/**
 * What is left of a crash: a text file to attach to an issue. It holds no path below the user's home folder, only
 * {@code ~}.
 */
public record CrashReport(List<String> arguments, Instant when, Throwable crash) {
    /** Writes the report below {@code build/} of a checkout, else into the folder for temporary files. */
    public Path write() throws IOException {
        Path checkout = Path.of("build");
        Path folder = Files.isDirectory(checkout) ? checkout.resolve("crashes") : temporaryFolder();
        Files.createDirectories(folder);
        String stamp = when.toString().replaceAll("[^0-9]", "");
        return Files.writeString(folder.resolve("nephele-crash-" + stamp + ".txt"), text());
    }

    /** The report without any path below the home folder. */
    public String text() {
        var stackTrace = new StringWriter();
        crash.printStackTrace(new PrintWriter(stackTrace));
        String report = "Nephele crash report\n"
                + "when      " + when + "\n"
                + "arguments " + String.join(" ", arguments) + "\n"
                + "java      " + System.getProperty("java.vendor") + " " + System.getProperty("java.version") + "\n"
                + "system    " + System.getProperty("os.name") + " " + System.getProperty("os.version") + " "
                + System.getProperty("os.arch") + "\n\n"
                + stackTrace;
        return withoutHome(report, System.getProperty("user.home", ""));
    }

    private static String withoutHome(String text, String home) {
        boolean tellsSomething = home.length() > 1;
        return tellsSomething ? text.replace(home, "~") : text;
    }

    private static Path temporaryFolder() {
        return Path.of(System.getProperty("java.io.tmpdir", "."));
    }
}
