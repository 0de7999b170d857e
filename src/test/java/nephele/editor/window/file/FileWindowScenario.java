package nephele.editor.window.file;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.List;
import nephele.editor.file.FiledSession;
import nephele.editor.file.SessionJournal;
import nephele.editor.save.DraftLevel;
import nephele.editor.save.journal.JournalFolder;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.session.EditorSetting.Theme;
import nephele.editor.start.WindowedEditing;
import nephele.editor.window.WindowRobot;
import nephele.engine.level.json.LevelFile;

/**
 * The editor's window over work that a crash has left, used with the mouse, in a process of its own; prints a line for
 * each step.
 */
public final class FileWindowScenario {
    private final Path folder;
    private final EditorSession session;
    private final WindowRobot robot;

    private FileWindowScenario(Path folder, File pictures, Theme theme) throws Exception {
        this.folder = folder;
        session = FiledSession.untitled(folder);
        session.settings(session.settings().with(EditorSetting.THEME, theme));
        robot = new WindowRobot(pictures, () -> "status: " + session.status().english());
    }

    /** @param words folder of the level and the editor's own files, folder of pictures, theme */
    public static void main(String[] words) throws Exception {
        int status = 1;
        try {
            new FileWindowScenario(Path.of(words[0]), new File(words[1]), Theme.valueOf(words[2])).run();
            status = 0;
        } catch (IllegalStateException inVain) {
            System.err.println(inVain.getMessage());
        } finally {
            // The dispatch thread would keep the process alive after a failure.
            System.exit(status);
        }
    }

    private void run() throws Exception {
        Path file = folder.resolve("room.json");
        EditorSession lost = FiledSession.of(folder, file, DraftLevel.after(0));
        SessionJournal journal = new SessionJournal(
                lost, new JournalFolder(folder.resolve("journal"), InstantSource.system()), words -> {});
        FiledSession.edit(lost, DraftLevel.after(1));
        journal.leave();
        new WindowedEditing(session, FiledSession.files(folder), () -> List.of("false"), System.err::println)
                .open(() -> {});
        answer("recovery", "Recover");
        robot.await("the lost level", () -> session.document().level().equals(DraftLevel.after(1)));
        System.out.println("recovered: " + session.document().isModified());
        LevelFile.save(file, DraftLevel.after(2));
        answer("changed", "Keep Mine");
        System.out.println("kept mine: " + session.document().level().equals(DraftLevel.after(1)));
        Files.delete(file);
        answer("deleted", "OK");
        System.out.println("told of the deletion: " + session.document().isModified());
    }

    private void answer(String picture, String button) throws Exception {
        robot.await("the dialogue " + picture, () -> WindowRobot.dialog() != null);
        robot.picture("window-" + picture);
        robot.clickButton(button);
        robot.await("the end of the dialogue", () -> WindowRobot.dialog() == null);
    }
}
