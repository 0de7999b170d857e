package nephele.app.command;

import java.nio.file.Path;
import java.util.List;

/** The command line of the report that the editor asks for: the same Java and the same classes as this process. */
final class TradeReportLine {
    private static final String MAIN_CLASS = "nephele.app.Main";

    private TradeReportLine() {}

    /** Returns the program and its arguments. */
    static List<String> words(Path level, Path out) {
        return List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                MAIN_CLASS,
                "trade",
                "--quick",
                "--level",
                level.toString(),
                "--out",
                out.toString());
    }
}
