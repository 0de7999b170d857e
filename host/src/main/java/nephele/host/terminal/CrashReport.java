package nephele.host.terminal;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;

/**
 * A crash report, a text file to attach to an issue. The user's home folder is replaced by {@code ~}.
 *
 * @param arguments of the command line
 * @param when time of the crash
 */
public record CrashReport(List<String> arguments, Instant when, Throwable crash) {
    /**
     * Writes the report below {@code build/} of a checkout, otherwise into the temporary folder, and returns its path.
     */
    public Path write() throws IOException {
        Path checkout = Path.of("build");
        Path folder = Files.isDirectory(checkout) ? checkout.resolve("crashes") : temporaryFolder();
        Files.createDirectories(folder);
        String stamp = when.toString().replaceAll("[^0-9]", "");
        return Files.writeString(folder.resolve("nephele-crash-" + stamp + ".txt"), text());
    }

    /** Returns the report with the home folder replaced. */
    public String text() {
        var stackTrace = new StringWriter();
        crash.printStackTrace(new PrintWriter(stackTrace));
        String report = "Nephele crash report\n"
                + "program   " + ProgramVersion.line() + "\n"
                + "when      " + when + "\n"
                + "arguments " + String.join(" ", arguments) + "\n"
                + "java      " + System.getProperty("java.vendor") + " " + System.getProperty("java.version") + "\n"
                + "system    " + System.getProperty("os.name") + " " + System.getProperty("os.version") + "\n\n"
                + stackTrace;
        return withoutHome(report, System.getProperty("user.home", ""));
    }

    private static String withoutHome(String text, String home) {
        boolean isFolder = home.length() > 1;
        return isFolder ? text.replace(home, "~") : text;
    }

    private static Path temporaryFolder() {
        return Path.of(System.getProperty("java.io.tmpdir", "."));
    }
}
