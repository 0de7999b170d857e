package nephele.app.command;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** The command line of the report that the editor asks for: the same Java and the same classes as this process. */
final class TradeReportLine {
    private static final String MAIN_CLASS = "nephele.app.Main";

    /** The subjects whose figures are those of the level's pictures. */
    private static final List<String> SUBJECTS = List.of(
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

    private TradeReportLine() {}

    /** Returns the program and its arguments. */
    static List<String> words(Path level, Path out) {
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
        words.addAll(SUBJECTS);
        return words;
    }
}
