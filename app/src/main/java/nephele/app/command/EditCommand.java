package nephele.app.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import nephele.app.window.SystemDisplay;
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

/** Opens the level editor, or runs a script of its actions without a display. */
@picocli.CommandLine.Command
final class EditCommand implements Command {
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
        session.proving().trade().madeBy(OwnCommandLine::tradeReport);
        if (script != null) {
            return runScript(session, terminal);
        }
        terminal.shown().run();
        CountDownLatch ended = new CountDownLatch(1);
        new WindowedEditing(
                        session,
                        files,
                        () -> OwnCommandLine.waitingGame(session.file().path().orElse(null)),
                        terminal.err()::println)
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
}
