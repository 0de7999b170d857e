package nephele.app.window;

import static org.lwjgl.glfw.GLFW.*;
import static org.lwjgl.system.MemoryUtil.NULL;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import nephele.host.terminal.CommandFailure;
import org.lwjgl.glfw.Callbacks;
import org.lwjgl.glfw.GLFWErrorCallback;
import org.lwjgl.glfw.GLFWGamepadState;
import org.lwjgl.system.Configuration;

/**
 * A window with an OpenGL 4.1 core context, current on the thread that opened it. Sizes are in framebuffer pixels,
 * which on a high-DPI screen are more than the window's units.
 */
public final class GameWindow implements AutoCloseable {
    /** The least size to which the window can be dragged: below it letters shrink. It may be opened smaller. */
    private static final int LEAST_WIDTH = 640;

    private static final int LEAST_HEIGHT = 360;

    private final long handle;
    private final WindowEvents events;
    private InputListener input;
    private final WindowPlace place;
    private final GLFWGamepadState padState = GLFWGamepadState.calloc();

    private GameWindow(long handle, InputListener input) {
        this.handle = handle;
        this.input = input;
        events = new WindowEvents(handle, input);
        place = new WindowPlace(handle);
    }

    /** Opens the window; a failure reports the system's messages (exit code 3). */
    public static GameWindow open(String title, Size size, InputListener input) {
        return open(title, size, input, GLFW_TRUE);
    }

    /** Opens the window as {@link #open} does, but invisible until {@link #reveal}. */
    public static GameWindow openHidden(String title, Size size, InputListener input) {
        return open(title, size, input, GLFW_FALSE);
    }

    private static GameWindow open(String title, Size size, InputListener input, int visible) {
        List<String> complaints = new ArrayList<>();
        String system = System.getProperty("os.name").toLowerCase(Locale.ROOT);
        if (system.contains("mac")) {
            Configuration.GLFW_LIBRARY_NAME.set("glfw_async"); // works without -XstartOnFirstThread
        }
        glfwSetErrorCallback((error, description) -> complaints.add(GLFWErrorCallback.getDescription(description)));
        if (system.contains("linux") && System.getenv("DISPLAY") != null) {
            glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
        }
        if (!glfwInit()) {
            throw SystemDisplay.unavailable(
                    reason(complaints),
                    "without a display, unset DISPLAY and WAYLAND_DISPLAY: Nephele then draws offscreen");
        }
        askForCoreContext();
        glfwWindowHint(GLFW_VISIBLE, visible);
        long handle = glfwCreateWindow(size.width(), size.height(), title, NULL, NULL);
        if (handle == NULL) {
            glfwTerminate();
            throw CommandFailure.environment("no window with OpenGL 4.1 core can be opened: " + reason(complaints)
                    + "; install a graphics driver with OpenGL 4.1 (on Debian or Ubuntu: apt-get install libgl1"
                    + " libgl1-mesa-dri), or unset DISPLAY and WAYLAND_DISPLAY: Nephele then draws offscreen");
        }
        glfwSetWindowSizeLimits(
                handle,
                Math.min(LEAST_WIDTH, size.width()),
                Math.min(LEAST_HEIGHT, size.height()),
                GLFW_DONT_CARE,
                GLFW_DONT_CARE);
        glfwMakeContextCurrent(handle);
        glfwSwapInterval(1);
        return new GameWindow(handle, input);
    }

    /** @param complaints the error messages of the window system */
    private static String reason(List<String> complaints) {
        return complaints.isEmpty() ? "the system gives no reason" : String.join("; ", complaints);
    }

    private static void askForCoreContext() {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
        glfwWindowHint(GLFW_DEPTH_BITS, 24);
    }

    /** Passes keys and mouse to another input from now on; the former one has no key down any more. */
    public void listen(InputListener other) {
        input.forget();
        input = other;
        events.listen(other);
    }

    /** Processes the window events since the last call. */
    public void poll() {
        glfwPollEvents();
    }

    /** Waits for an event, at most this long: for a window that is not visible. */
    public void waitForEvents(double seconds) {
        glfwWaitEventsTimeout(seconds);
    }

    /** Sets the title bar's text. */
    public void title(String title) {
        glfwSetWindowTitle(handle, title);
    }

    /** Presents the frame (swaps the buffers). */
    public void show() {
        glfwSwapBuffers(handle);
    }

    public boolean closeRequested() {
        return glfwWindowShouldClose(handle);
    }

    /** Makes an invisible window visible, above the others and with the focus. */
    public void reveal() {
        glfwSetWindowShouldClose(handle, false);
        glfwShowWindow(handle);
        glfwRequestWindowAttention(handle);
        glfwFocusWindow(handle);
    }

    /** Makes the window invisible and releases all keys. */
    public void hide() {
        captureMouse(false);
        glfwHideWindow(handle);
        input.forget();
    }

    /** Returns true once after the window lost the focus. */
    public boolean takeFocusLoss() {
        return events.takeFocusLoss();
    }

    /** Waits for the screen before a frame is shown, or does not. */
    public void verticalSync(boolean isOn) {
        glfwSwapInterval(isOn ? 1 : 0);
    }

    public boolean hasFocus() {
        return events.hasFocus();
    }

    public int width() {
        return events.width();
    }

    public int height() {
        return events.height();
    }

    /** Returns false while the window is minimised or has no area: nothing can be drawn then. */
    public boolean isDrawable() {
        return !events.isMinimised() && width() > 0 && height() > 0;
    }

    /** Returns the pixels per point: 2 on a high-DPI screen. */
    public double scale() {
        return events.scale();
    }

    /** Hides the pointer and captures the mouse for the game, or releases it. */
    public void captureMouse(boolean captured) {
        int mode = captured ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL;
        if (glfwGetInputMode(handle, GLFW_CURSOR) != mode) {
            glfwSetInputMode(handle, GLFW_CURSOR, mode);
            if (glfwRawMouseMotionSupported()) {
                glfwSetInputMode(handle, GLFW_RAW_MOUSE_MOTION, captured ? GLFW_TRUE : GLFW_FALSE);
            }
            events.lookWithMouse(captured);
            input.forgetMouse();
        }
    }

    public WindowMode mode() {
        return place.mode();
    }

    /**
     * Changes the kind of window, on the screen that it is on.
     *
     * @param size of a free window, or of the picture of a full screen; {@code null} to keep the window's, or for the
     *     screen's own
     */
    public void become(WindowMode mode, Size size) {
        place.become(mode, size);
        input.forget();
    }

    /** Returns the state of the first gamepad that the system knows; {@link PadState#RELEASED} without one. Allocates nothing then. */
    public PadState pad() {
        for (int joystick = GLFW_JOYSTICK_1; joystick <= GLFW_JOYSTICK_LAST; joystick++) {
            if (glfwJoystickPresent(joystick)
                    && glfwJoystickIsGamepad(joystick)
                    && glfwGetGamepadState(joystick, padState)) {
                return readPad();
            }
        }
        return PadState.RELEASED;
    }

    private PadState readPad() {
        var down = EnumSet.noneOf(PadButton.class);
        for (PadButton button : PadButton.values()) {
            if (button.ordinal() <= GLFW_GAMEPAD_BUTTON_LAST && padState.buttons(button.ordinal()) == GLFW_PRESS) {
                down.add(button);
            }
        }
        addIfPulled(down, PadButton.LT, GLFW_GAMEPAD_AXIS_LEFT_TRIGGER);
        addIfPulled(down, PadButton.RT, GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER);
        return new PadState(
                down,
                padState.axes(GLFW_GAMEPAD_AXIS_LEFT_X),
                padState.axes(GLFW_GAMEPAD_AXIS_LEFT_Y),
                padState.axes(GLFW_GAMEPAD_AXIS_RIGHT_X),
                padState.axes(GLFW_GAMEPAD_AXIS_RIGHT_Y));
    }

    /** A trigger's axis runs from −1 to 1. */
    private void addIfPulled(EnumSet<PadButton> down, PadButton trigger, int axis) {
        if ((padState.axes(axis) + 1) / 2 > Gamepad.PRESSED) {
            down.add(trigger);
        }
    }

    @Override
    public void close() {
        padState.free();
        Callbacks.glfwFreeCallbacks(handle);
        glfwDestroyWindow(handle);
        glfwTerminate();
        var complaints = glfwSetErrorCallback(null);
        if (complaints != null) {
            complaints.free();
        }
    }
}
