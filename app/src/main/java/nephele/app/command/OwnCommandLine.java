package nephele.app.command;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import nephele.editor.play.WarmGame;

/** Command lines of further processes for the editor, of the same Java and the same classes as this one. */
final class OwnCommandLine {
    /** The main class, by name, because it uses this package. */
    private static final String MAIN_CLASS = "nephele.app.Main";

    private static final int FIRST_WITH_UNSAFE_WARNINGS = 23;

    /** The subjects whose figures are those of the level's pictures. */
    private static final List<String> REPORT_SUBJECTS = List.of(
            "quality",
            "pictureResolution",
            "edgeFilter",
            "shadowFilter",
            "lightShadows",
            "portalTechnique",
            "viewBudget",
            "portalResolution",
            "samples",
            "anisotropy");

    private OwnCommandLine() {}

    /**
     * Returns the command line of the game that waits for the editor.
     *
     * @param level the file of the open level, with which the game warms itself; {@code null} for none
     */
    static List<String> waitingGame(Path level) {
        String classPath = System.getProperty("java.class.path");
        var words = new ArrayList<String>();
        words.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        words.addAll(WarmGame.JAVA_OPTIONS);
        words.addAll(archive(classPath));
        if (Runtime.version().feature() >= FIRST_WITH_UNSAFE_WARNINGS) {
            words.add("--sun-misc-unsafe-memory-access=allow");
        }
        words.addAll(List.of("-cp", classPath, MAIN_CLASS, "play", "--warm"));
        if (level != null && Files.isRegularFile(level)) {
            words.add(level.toAbsolutePath().toString());
        }
        return words;
    }

    /** Returns the options for the archive of parsed classes that the start script keeps beside the jar, if it is there. */
    private static List<String> archive(String classPath) {
        if (!classPath.endsWith(".jar")) {
            return List.of();
        }
        var name = "nephele-java" + Runtime.version().feature() + ".jsa";
        Path archive = Path.of(classPath).toAbsolutePath().resolveSibling(name);
        return archive.toFile().length() > 0 && Files.isReadable(archive)
                ? List.of("-XX:SharedArchiveFile=" + archive, "-Xlog:cds=off", "-Xlog:cds+dynamic=off")
                : List.of();
    }

    /** Returns the command line of the report that the editor asks for. */
    static List<String> tradeReport(Path level, Path out) {
        List<String> words = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                MAIN_CLASS,
                "trade",
                "--quick",
                "--level",
                level.toString(),
                "--out",
                out.toString()));
        words.addAll(REPORT_SUBJECTS);
        return words;
    }
}
