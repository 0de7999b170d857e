package nephele.app.play;

import static org.lwjgl.glfw.GLFW.*;

import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import nephele.app.settings.PlayerFiles;
import nephele.app.window.Control;
import nephele.app.window.GameWindow;
import nephele.app.window.Input;
import nephele.app.window.Size;
import nephele.app.window.WindowMode;
import nephele.engine.render.gl.GlContext;
import nephele.engine.sim.state.SimSettings;
import nephele.host.draw.QualityChoice;
import nephele.host.named.LevelName;
import nephele.host.userfile.UserFolders;
import org.lwjgl.system.MemoryUtil;

/**
 * The game in a real window, run by {@link GameWindowSwingTest} in a process that has a display. Prints a line for each
 * scenario: its name and "ok", or the failure.
 */
public final class WindowScenarios {
    private static final int MOST_FRAMES = 400;
    private static final int WARMING_FRAMES = 200;
    private static final int MEASURED_FRAMES = 100;
    private static final double BYTES_OF_A_TICK = 1 << 10;
    private static final double MOST_BYTES_IN_PLAY = 2 << 10;
    private static final double MOST_BYTES_IN_MENUS = 64 << 10;

    private final Input input = new Input();
    private final GameWindow window = GameWindow.open("Nephele test", new Size(320, 180), input);
    private final long handle = glfwGetCurrentContext();
    private final GlContext gl = GlContext.ofCurrent();
    private final Map<?, Integer> baseline = gl.live().counts();
    private final GameLoop loop;
    private double frameBytes;

    private WindowScenarios(String level) {
        var picture = new PlayRequest.Picture(320, 180, false);
        var quality = new QualityChoice("low", Map.of());
        var player = new PlayRequest.Player(new PlayerFiles(new UserFolders(null, null, null)), null);
        loop = new GameLoop(
                new PlayRequest(
                        new LevelName(level),
                        null,
                        quality,
                        null,
                        Path.of("walk.json"),
                        SimSettings.DEFAULT,
                        null,
                        picture,
                        player),
                window,
                gl,
                input);
    }

    /** An action, and a condition that must hold within a number of frames. */
    private record Scenario(String name, Runnable act, BooleanSupplier holds) {}

    public static void main(String[] args) {
        var scenarios = new WindowScenarios(args[0]);
        for (var scenario : scenarios.all()) {
            System.out.println(scenario.name + ": " + scenarios.outcome(scenario));
        }
        scenarios.finish();
    }

    private List<Scenario> all() {
        long[] other = new long[1];
        return List.of(
                new Scenario("starts", () -> {}, () -> loop.stage() == GameStage.RUNNING && isSize(320, 180)),
                new Scenario("captures the mouse", () -> {}, () -> cursor() == GLFW_CURSOR_DISABLED),
                new Scenario("resizes", () -> glfwSetWindowSize(handle, 500, 260), () -> isSize(500, 260)),
                new Scenario("shrinks to a line", () -> glfwSetWindowSize(handle, 300, 1), () -> isSize(300, 1)),
                new Scenario("grows again", () -> glfwSetWindowSize(handle, 400, 200), () -> isSize(400, 200)),
                new Scenario("is minimised", () -> minimise(true), () -> !window.isDrawable()),
                new Scenario("comes back", () -> minimise(false), window::isDrawable),
                new Scenario(
                        "loses the focus",
                        () -> {
                            input.key(Control.FORWARD, true);
                            other[0] = focusAnother();
                        },
                        () -> !input.holds(Control.FORWARD) && cursor() == GLFW_CURSOR_NORMAL),
                new Scenario(
                        "is paused then",
                        () -> {
                            glfwDestroyWindow(other[0]);
                            glfwFocusWindow(handle);
                        },
                        () -> loop.stage() == GameStage.MENU && window.hasFocus()),
                new Scenario(
                        "continues with the focus",
                        () -> press(Control.CONFIRM),
                        () -> cursor() == GLFW_CURSOR_DISABLED && input.takeCountsRight() == 0),
                new Scenario("fills the screen", () -> press(Control.FULL_SCREEN), () -> isSize(1024, 600)),
                new Scenario("leaves the full screen", () -> press(Control.FULL_SCREEN), () -> isSize(400, 200)),
                new Scenario(
                        "covers the screen without a frame",
                        () -> window.become(WindowMode.BORDERLESS, null),
                        () -> isSize(1024, 600) && glfwGetWindowAttrib(handle, GLFW_DECORATED) == GLFW_FALSE),
                new Scenario(
                        "has a frame again and another size",
                        () -> window.become(WindowMode.WINDOWED, new Size(360, 190)),
                        () -> isSize(360, 190) && glfwGetWindowAttrib(handle, GLFW_DECORATED) == GLFW_TRUE),
                new Scenario("draws steadily", this::measureFrames, () -> frameBytes <= MOST_BYTES_IN_PLAY),
                new Scenario("shows figures", () -> press(Control.FIGURES), () -> loop.stage() == GameStage.RUNNING),
                new Scenario("opens the menu", () -> press(Control.MENU), () -> loop.stage() == GameStage.MENU),
                new Scenario("rests in it", this::measureFrames, () -> frameBytes <= MOST_BYTES_IN_MENUS),
                new Scenario("frees the mouse in it", () -> {}, () -> cursor() == GLFW_CURSOR_NORMAL),
                new Scenario("continues", () -> press(Control.CONFIRM), () -> loop.stage() == GameStage.RUNNING),
                new Scenario(
                        "captures it again and keeps the first key",
                        () -> input.key(Control.FORWARD, true),
                        () -> cursor() == GLFW_CURSOR_DISABLED && input.holds(Control.FORWARD)),
                new Scenario(
                        "asks before it restarts", () -> press(Control.RESTART), () -> loop.stage() == GameStage.MENU),
                new Scenario(
                        "goes back to the game from the question",
                        () -> press(Control.MENU),
                        () -> loop.stage() == GameStage.RUNNING),
                new Scenario("pauses again", () -> press(Control.MENU), () -> loop.stage() == GameStage.MENU),
                new Scenario(
                        "changes nothing below the menu",
                        () -> List.of(Control.FIGURES, Control.PERSON, Control.CROUCH)
                                .forEach(this::press),
                        () -> loop.showsFigures() && loop.stage() == GameStage.MENU),
                new Scenario("shows the keys over the menu", () -> press(Control.HELP), loop::showsHelp),
                new Scenario(
                        "chooses nothing that the keys cover",
                        () -> List.of(Control.BACK, Control.CONFIRM, Control.JUMP)
                                .forEach(this::press),
                        () -> loop.showsHelp() && loop.stage() == GameStage.MENU),
                new Scenario("closes the keys", () -> press(Control.MENU), () -> !loop.showsHelp()),
                new Scenario(
                        "is still at the first entry",
                        () -> press(Control.CONFIRM),
                        () -> loop.stage() == GameStage.RUNNING && !input.takeHold(Control.CROUCH)),
                new Scenario(
                        "asks again before it restarts",
                        () -> press(Control.RESTART),
                        () -> loop.stage() == GameStage.MENU),
                new Scenario("selects the restart", () -> press(Control.BACK), () -> loop.stage() == GameStage.MENU),
                new Scenario("restarts", () -> press(Control.CONFIRM), this::hasRestarted),
                new Scenario("takes a picture", () -> press(Control.SCREENSHOT), this::hasPicture),
                new Scenario(
                        "closes",
                        () -> glfwSetWindowShouldClose(handle, true),
                        () -> loop.stage() == GameStage.LEAVING));
    }

    private String outcome(Scenario scenario) {
        scenario.act.run();
        for (int frame = 0; frame < MOST_FRAMES; frame++) {
            if (loop.stage() != GameStage.LEAVING) {
                loop.frame();
            }
            gl.requireNoError(scenario.name);
            if (scenario.holds.getAsBoolean()) {
                return "ok";
            }
        }
        return "not after " + MOST_FRAMES + " frames; " + frameBytes + " bytes a frame, size " + window.width() + "x"
                + window.height() + ", stage " + loop.stage() + ", focus " + window.hasFocus();
    }

    private void finish() {
        loop.close();
        boolean nothingLeft = gl.live().counts().equals(baseline);
        System.out.println(
                "leaves nothing behind: " + (nothingLeft ? "ok" : gl.live().counts()));
        gl.close();
        window.close();
    }

    private void press(Control control) {
        input.key(control, true);
        input.key(control, false);
    }

    private boolean isSize(int width, int height) {
        return window.width() == width && window.height() == height;
    }

    /**
     * Measures the heap memory that this thread takes for a frame, bytes, when caches are warm; without that of the
     * ticks, which have a bound of their own.
     */
    private void measureFrames() {
        var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        long bytes = 0;
        long nanos = 0;
        for (int frame = -WARMING_FRAMES; frame < MEASURED_FRAMES; frame++) {
            bytes = frame == 0 ? threads.getCurrentThreadAllocatedBytes() : bytes;
            nanos = frame == 0 ? System.nanoTime() : nanos;
            loop.frame();
        }
        bytes = threads.getCurrentThreadAllocatedBytes() - bytes;
        double ticks = loop.stage() == GameStage.RUNNING
                ? SimSettings.DEFAULT.ticksPerSecond() * (System.nanoTime() - nanos) / 1e9
                : 0;
        frameBytes = (bytes - ticks * BYTES_OF_A_TICK) / MEASURED_FRAMES;
    }

    private int cursor() {
        return glfwGetInputMode(handle, GLFW_CURSOR);
    }

    /** Minimises the window by its callback, as there is no window manager that could. */
    private void minimise(boolean minimised) {
        var listener = glfwSetWindowIconifyCallback(handle, null);
        listener.invoke(handle, minimised);
        glfwSetWindowIconifyCallback(handle, listener);
    }

    private static long focusAnother() {
        glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
        long other = glfwCreateWindow(100, 100, "another", MemoryUtil.NULL, MemoryUtil.NULL);
        glfwFocusWindow(other);
        return other;
    }

    /** Returns true if the level runs again and the earlier walk was recorded. */
    private boolean hasRestarted() {
        return loop.stage() == GameStage.RUNNING
                && Path.of("walk.json").toFile().exists();
    }

    private boolean hasPicture() {
        var pictures = Path.of("pictures").toFile().list();
        return pictures != null && pictures.length == 1;
    }
}
