package nephele.app.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import nephele.app.window.SystemDisplay;
import nephele.editor.play.WarmGame;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorFiles;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSettings;
import nephele.editor.session.FileServices;
import nephele.editor.start.ScriptedEditing;
import nephele.editor.start.WindowedEditing;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.TextFile;
import nephele.host.terminal.CommandFailure;
import nephele.host.terminal.ExitCode;
import nephele.host.terminal.Terminal;
import nephele.host.userfile.UserFolders;
import nephele.scenes.file.SceneImport;
import nephele.scenes.file.SceneName;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/**
 * Opens the level editor, or runs a script of its actions without a display. The editor starts further processes, of the
 * same Java and the same classes as this one.
 */
@picocli.CommandLine.Command
final class EditCommand implements Command {
    /** The main class, by name, because it uses this package. */
    private static final String MAIN_CLASS = "nephele.app.Main";

    private static final int FIRST_WITH_UNSAFE_WARNINGS = 23;

    /** The subjects whose figures are those of the level's pictures. */
    private static final List<String> REPORT_SUBJECTS = List.of(
            "quality",
            "pictureResolution",
            "antialiasing",
            "shadowFilter",
            "lightShadows",
            "portalTechnique",
            "viewBudget",
            "portalResolution",
            "samples",
            "anisotropy");

    @Parameters(arity = "0..1", paramLabel = "LEVEL", description = "A level file (default: a new level).")
    private String level;

    @Option(
            names = "--script",
            paramLabel = "F",
            description =
                    "Run the lines ACTION key=value … of a file and leave; docs/editor-keys.md lists the actions.")
    private Path script;

    /** Accepted, from scripts for earlier versions, in which a canvas could be chosen; the user is told that it is over. */
    @Option(names = "--viewport", hidden = true)
    private String formerViewport;

    @Override
    public ExitCode run(Terminal terminal) throws InterruptedException {
        if (script == null) {
            SystemDisplay.requireForSwing(
                    "without a display, run the editor's actions from a file with --script F (docs/editor-keys.md)");
        }
        if (formerViewport != null) {
            terminal.err().println("--viewport has no effect any more: leave it out");
        }
        EditorFiles files = EditorFiles.in(UserFolders.ofThisUser());
        EditorSettings settings = script == null ? files.read(terminal.err()::println) : EditorSettings.DEFAULT;
        DocumentFile.Opened opened = level == null ? DocumentFile.untitled() : DocumentFile.open(level);
        opened.notice().ifPresent(terminal.err()::println);
        EditorSession session = new EditorSession(opened.file(), opened.level(), opened.assets(), settings);
        session.panes(panes -> panes.opened(opened.level()));
        session.fileServices(FileServices.of(files).with(EditCommand::importScene));
        session.proving().trade().madeBy(EditCommand::tradeReport);
        if (script != null) {
            return runScript(session, terminal);
        }
        terminal.shown().run();
        CountDownLatch ended = new CountDownLatch(1);
        new WindowedEditing(
                        session, files, () -> waitingGame(session.file().path().orElse(null)), terminal.err()::println)
                .open(ended::countDown);
        ended.await();
        return ExitCode.DONE;
    }

    private static void importScene(Path scene, Path level, Consumer<String> complaints) throws EditorRefusal {
        try {
            SceneImport.save(new SceneName(scene.toString()), level, complaints);
        } catch (CommandFailure failure) {
            throw new EditorRefusal(Words.same(failure.getMessage()));
        }
    }

    private ExitCode runScript(EditorSession session, Terminal terminal) {
        System.setProperty("java.awt.headless", "true");
        Optional<String> failed = new ScriptedEditing(session).run(lines());
        failed.ifPresent(line -> terminal.err().println(script + ":" + line));
        return failed.isPresent() ? ExitCode.INPUT : ExitCode.DONE;
    }

    private List<String> lines() {
        try {
            return TextFile.lines(script);
        } catch (IOException problem) {
            throw CommandFailure.input(script + ": can't be read: " + AtomicFile.reason(problem));
        }
    }

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
