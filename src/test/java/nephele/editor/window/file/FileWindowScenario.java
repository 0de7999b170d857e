package nephele.editor.window.file;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import javax.imageio.ImageIO;
import javax.swing.AbstractButton;
import javax.swing.JDialog;
import nephele.editor.file.FiledSession;
import nephele.editor.file.SessionJournal;
import nephele.editor.save.DraftLevel;
import nephele.editor.save.journal.JournalFolder;
import nephele.editor.session.EditorSession;
import nephele.editor.settings.EditorSetting;
import nephele.editor.settings.EditorSetting.Theme;
import nephele.editor.start.WindowedEditing;
import nephele.editor.surface.SurfaceMode;
import nephele.engine.level.json.LevelFile;

/**
 * The editor's window over work that a crash has left, used with the mouse, in a process of its own; prints a line for
 * each step.
 */
public final class FileWindowScenario {
    private static final int LONGEST_STEPS = 600;
    private static final int STEP_MILLIS = 50;

    private final Path folder;
    private final File pictures;
    private final Robot robot = new Robot();
    private final EditorSession session;

    private FileWindowScenario(Path folder, File pictures, Theme theme) throws Exception {
        this.folder = folder;
        this.pictures = pictures;
        session = FiledSession.untitled(folder);
        session.settings(session.settings().with(EditorSetting.THEME, theme));
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
                .open(SurfaceMode.OFFSCREEN, () -> {});
        await(() -> dialog() != null);
        answer("recovery", "Recover");
        await(() -> session.document().level().equals(DraftLevel.after(1)) && dialog() == null);
        System.out.println("recovered: " + session.document().isModified());
        LevelFile.save(file, DraftLevel.after(2));
        await(() -> dialog() != null);
        answer("changed", "Keep Mine");
        await(() -> dialog() == null);
        System.out.println("kept mine: " + session.document().level().equals(DraftLevel.after(1)));
        Files.delete(file);
        await(() -> dialog() != null);
        answer("deleted", "OK");
        await(() -> dialog() == null);
        System.out.println("told of the deletion: " + session.document().isModified());
    }

    /** Returns the visible dialogue; {@code null} for none. */
    private static JDialog dialog() {
        for (Window window : Window.getWindows()) {
            if (window instanceof JDialog dialog && dialog.isShowing()) {
                return dialog;
            }
        }
        return null;
    }

    private static <T> T onDispatchThread(Supplier<T> question) throws Exception {
        Object[] answer = new Object[1];
        EventQueue.invokeAndWait(() -> answer[0] = question.get());
        @SuppressWarnings("unchecked")
        T typed = (T) answer[0];
        return typed;
    }

    private void await(BooleanSupplier condition) throws Exception {
        for (int i = 0; !onDispatchThread(condition::getAsBoolean); i++) {
            if (i == LONGEST_STEPS) {
                throw new IllegalStateException(
                        "waited in vain; status: " + session.status().english());
            }
            robot.delay(STEP_MILLIS);
        }
    }

    private void answer(String picture, String button) throws Exception {
        Point middle = onDispatchThread(() -> middle(find(dialog(), button)));
        robot.mouseMove(middle.x, middle.y);
        // A click before the display shows the dialogue would go to the window behind it.
        await(() -> dialog().getMousePosition(true) != null);
        robot.delay(2 * STEP_MILLIS);
        Rectangle screen = new Rectangle(Toolkit.getDefaultToolkit().getScreenSize());
        pictures.mkdirs();
        ImageIO.write(robot.createScreenCapture(screen), "png", new File(pictures, "window-" + picture + ".png"));
        robot.waitForIdle();
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        robot.delay(STEP_MILLIS);
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    }

    private static Point middle(AbstractButton button) {
        Point at = button.getLocationOnScreen();
        at.translate(button.getWidth() / 2, button.getHeight() / 2);
        return at;
    }

    private static AbstractButton find(Container container, String text) {
        for (Component child : container.getComponents()) {
            if (child instanceof AbstractButton button && text.equals(button.getText())) {
                return button;
            }
            AbstractButton inner = child instanceof Container deeper ? find(deeper, text) : null;
            if (inner != null) {
                return inner;
            }
        }
        return null;
    }
}
