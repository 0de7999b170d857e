package nephele.app.window;

import static org.lwjgl.glfw.GLFW.*;

/** The GLFW callbacks of one window: keep its state for the window, and pass keys and mouse to the input. */
final class WindowEvents {
    private final long handle;
    private InputListener input;
    private int width;
    private int height;
    private boolean minimised;
    private boolean focus;
    private boolean focusLost;
    private double scale = 1;
    private boolean looking;

    WindowEvents(long handle, InputListener first) {
        this.handle = handle;
        input = first;
        readInitialState();
        glfwSetFramebufferSizeCallback(handle, (window, newWidth, newHeight) -> {
            width = newWidth;
            height = newHeight;
        });
        glfwSetWindowIconifyCallback(handle, (window, now) -> minimised = now);
        glfwSetWindowContentScaleCallback(handle, (window, x, y) -> scale = x);
        glfwSetWindowFocusCallback(handle, (window, now) -> {
            focusLost |= focus && !now;
            focus = now;
            input.forget();
        });
        glfwSetKeyCallback(handle, (window, key, scanCode, action, modifiers) -> {
            if (action == GLFW_REPEAT) {
                input.repeated(key);
            } else {
                input.key(key, action == GLFW_PRESS);
            }
        });
        glfwSetCursorPosCallback(handle, (window, x, y) -> moved(x, y));
        glfwSetScrollCallback(handle, (window, x, y) -> input.scroll(y));
        glfwSetMouseButtonCallback(handle, (window, button, action, modifiers) -> {
            if (looking) {
                input.key(InputListener.MOUSE + button, action == GLFW_PRESS);
            } else if (button == GLFW_MOUSE_BUTTON_LEFT) {
                leftButton(action == GLFW_PRESS);
            } else {
                input.key(InputListener.MOUSE + button, action == GLFW_PRESS);
            }
        });
    }

    /** Passes keys and mouse to another input from now on. */
    void listen(InputListener other) {
        input = other;
    }

    private void readInitialState() {
        int[] a = new int[1];
        int[] b = new int[1];
        glfwGetFramebufferSize(handle, a, b);
        width = a[0];
        height = b[0];
        float[] x = new float[1];
        float[] y = new float[1];
        glfwGetWindowContentScale(handle, x, y);
        scale = x[0];
        focus = glfwGetWindowAttrib(handle, GLFW_FOCUSED) == GLFW_TRUE;
    }

    private void leftButton(boolean down) {
        if (down) {
            input.click();
        } else {
            input.letGo();
        }
    }

    /** Handles a pointer position. GLFW gives window units, which are scaled to framebuffer pixels. */
    private void moved(double x, double y) {
        if (looking) {
            input.look(x, y);
            return;
        }
        int[] windowWidth = new int[1];
        int[] windowHeight = new int[1];
        glfwGetWindowSize(handle, windowWidth, windowHeight);
        input.point(x * width / Math.max(1, windowWidth[0]), y * height / Math.max(1, windowHeight[0]));
    }

    /**
     * Switches between the captured mouse and the free pointer. A released pointer raises no event, so its position is
     * queried.
     */
    void lookWithMouse(boolean nowLooking) {
        looking = nowLooking;
        if (!looking) {
            double[] x = new double[1];
            double[] y = new double[1];
            glfwGetCursorPos(handle, x, y);
            moved(x[0], y[0]);
        }
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    boolean isMinimised() {
        return minimised;
    }

    /** Returns true once after the focus was lost. */
    boolean takeFocusLoss() {
        boolean taken = focusLost;
        focusLost = false;
        return taken;
    }

    boolean hasFocus() {
        return focus;
    }

    double scale() {
        return scale > 0 ? scale : 1;
    }
}
