package nephele.editor.start;

import java.awt.Component;
import java.awt.Point;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import nephele.app.Main;
import nephele.editor.file.FiledSession;
import nephele.editor.pane.PaneCamera.PanePoint;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PaneLayout;
import nephele.editor.pane.PaneLayout.PaneRectangle;
import nephele.editor.pane.PaneView;
import nephele.editor.panel.GuideStep;
import nephele.editor.play.WarmGame;
import nephele.editor.session.EditorSession;
import nephele.editor.window.WindowRobot;
import nephele.editor.window.viewport.ViewportPanel;
import nephele.engine.level.Level;
import nephele.engine.math.Vec3;

/**
 * Builds, saves, checks, solves and plays the first room as the guide says, with real mouse and keys, in a process of
 * its own; prints a line for each step and leaves a picture of it.
 */
public final class FirstRoomScenario {
    private static final long LONGEST_SECONDS = 20;
    /** The panels are darker than this, and so is a window without a picture. */
    private static final int LEAST_DAYLIGHT = 140;

    /** Where the editor proposes to save a new level, below the folder of the run. */
    static final Path OWN_LEVELS = Path.of("data/nephele/levels");

    private final Path folder;
    private final EditorSession session;
    private final WindowRobot robot;
    private final CountDownLatch closed = new CountDownLatch(1);

    private FirstRoomScenario(Path folder, File pictures) throws Exception {
        this.folder = folder;
        session = FiledSession.untitled(folder);
        robot = new WindowRobot(
                pictures,
                () -> "status: " + session.status().english() + "; "
                        + session.document().level());
    }

    /** @param words folder of the level and the editor's own files, folder of pictures */
    public static void main(String[] words) throws Exception {
        int status = 1;
        try {
            new FirstRoomScenario(Path.of(words[0]), new File(words[1])).run();
            status = 0;
        } catch (IllegalStateException inVain) {
            System.err.println(inVain.getMessage());
        } finally {
            // The dispatch thread would keep the process alive after a failure.
            System.exit(status);
        }
    }

    private void run() throws Exception {
        new WindowedEditing(session, FiledSession.files(folder), FirstRoomScenario::game, System.err::println)
                .open(closed::countDown);
        robot.await(
                "the viewport",
                () -> session.viewport().width() > 300
                        && isTold(GuideStep.ROOM.title().english()));
        Point ground = at(PaneKind.PERSPECTIVE, Vec3.ZERO);
        robot.await("the first frame", () -> robot.colour(ground).getBlue() > LEAST_DAYLIGHT);
        step(GuideStep.ROOM, "01-guide");
        robot.drag(at(PaneKind.TOP, new Vec3(-4.5, 0, -4.5)), at(PaneKind.TOP, new Vec3(4.5, 0, 4.5)));
        step(GuideStep.LAMP, "02-room");
        robot.click(at(PaneKind.PERSPECTIVE, new Vec3(0, 4, -1)));
        step(GuideStep.START, "03-lamp");
        robot.click(at(PaneKind.PERSPECTIVE, new Vec3(0, 0, 1)));
        robot.await("the start", () -> level().player() != null);
        robot.clickTab("Add");
        robot.clickButton("Exit");
        robot.click(at(PaneKind.PERSPECTIVE, new Vec3(0, 0, -3)));
        step(GuideStep.THINGS, "04-exit");
        robot.click(at(PaneKind.PERSPECTIVE, new Vec3(2, 0, -1)));
        robot.await("the cube", () -> !level().bodies().isEmpty());
        robot.clickButton("Cloud");
        robot.click(at(PaneKind.PERSPECTIVE, new Vec3(-2, 0, -2)));
        step(GuideStep.PORTALS, "05-cube-and-cloud");
        robot.click(at(PaneKind.PERSPECTIVE, new Vec3(-4, 1.4, -1.5)));
        robot.click(at(PaneKind.PERSPECTIVE, new Vec3(4, 1.4, -1.5)));
        step(GuideStep.PLAY, "06-portals");
        save();
        prove();
        play();
        leave();
    }

    private Level level() {
        return session.document().level();
    }

    /** Waits until the guide asks for a step. */
    private void step(GuideStep wanted, String picture) throws Exception {
        robot.await(wanted.name(), () -> isTold(wanted.title().english()));
        robot.picture(picture);
        System.out.println(picture);
    }

    private static boolean isTold(String text) {
        return WindowRobot.find(child -> child instanceof javax.swing.JLabel label && text.equals(label.getText()))
                .isPresent();
    }

    /** Returns the place on the display of a point of the world in the first pane of a kind. */
    private Point at(PaneKind kind, Vec3 point) throws Exception {
        return WindowRobot.asked(() -> {
            PaneLayout panes = session.panes();
            for (PaneRectangle pane : panes.rectangles(session.viewport(), PaneLayout.GAP_PIXELS)) {
                PaneView view = panes.views().get(pane.index());
                if (view.kind() == kind) {
                    PanePoint inside = view.camera().project(point, pane.size()).orElseThrow();
                    Point corner = viewport().getLocationOnScreen();
                    return new Point(corner.x + pane.x() + (int) inside.x(), corner.y + pane.y() + (int) inside.y());
                }
            }
            throw new IllegalStateException("no pane " + kind);
        });
    }

    private static Component viewport() {
        return WindowRobot.find(ViewportPanel.class::isInstance).orElseThrow();
    }

    /** Clicks beside the level: without a window manager no one gives the window the keyboard back. */
    private void takeKeys() throws Exception {
        robot.click(at(PaneKind.TOP, new Vec3(6.5, 0, 0)));
    }

    private void save() throws Exception {
        robot.keys("CONTROL", "S");
        robot.await("the file chooser", () -> WindowRobot.dialog() != null);
        robot.type("first-room");
        robot.picture("07-save");
        robot.keys("ENTER");
        robot.await(
                "the saved file",
                () -> session.file().path().isPresent() && !session.document().isModified());
        takeKeys();
        System.out.println("saved " + session.file().path().orElseThrow().getFileName());
    }

    private void prove() throws Exception {
        robot.keys("F7");
        awaitStatus("No problems");
        robot.keys("F6");
        awaitStatus("Playing");
        Predicate<String> isOver = status -> status.startsWith("Solution recorded");
        robot.hold("W", () -> isOver.test(session.status().english()));
        System.out.println("recorded " + Files.exists(folder.resolve(OWN_LEVELS).resolve("replays/first-room.json")));
        takeKeys();
        robot.keys("SHIFT", "F6");
        awaitStatus("Solved");
        robot.picture("08-solved");
        System.out.println("solved");
    }

    private void play() throws Exception {
        List<?> selected = session.document().selection().entities();
        robot.keys("F5");
        awaitStatus("Playing");
        robot.picture("09-play");
        robot.keys("ESCAPE");
        robot.await("the end of the game", () -> session.status().english().startsWith("Back"));
        System.out.println("played, same selection: "
                + session.document().selection().entities().equals(selected));
    }

    private void awaitStatus(String beginning) throws Exception {
        robot.await(beginning, () -> session.status().english().startsWith(beginning));
    }

    private void leave() throws Exception {
        takeKeys();
        robot.picture("10-end");
        robot.keys("CONTROL", "Q");
        if (!closed.await(LONGEST_SECONDS, TimeUnit.SECONDS)) {
            throw new IllegalStateException("the window is still open");
        }
        System.out.println("closed");
    }

    private static List<String> game() {
        var words = new ArrayList<String>();
        words.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        words.addAll(WarmGame.JAVA_OPTIONS);
        words.addAll(List.of("-Djoml.nounsafe=true", "-cp", System.getProperty("java.class.path")));
        words.addAll(List.of(Main.class.getName(), "play", "--warm", "--size", "640x360", "--quality", "low"));
        return words;
    }
}
