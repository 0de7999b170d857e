package nephele.app.window;

import static org.lwjgl.glfw.GLFW.*;
import static org.lwjgl.system.MemoryUtil.NULL;

import org.lwjgl.PointerBuffer;
import org.lwjgl.glfw.GLFWVidMode;

/** The bounds and the mode of a window on its screen. */
final class WindowPlace {
    private final long handle;
    private WindowMode mode = WindowMode.WINDOWED;
    private Bounds free;

    /** The bounds of the screen in the desktop's video mode; a full screen may have another one. */
    private Bounds desktop;

    /** A rectangle in screen units. */
    private record Bounds(int x, int y, int width, int height) {
        /** Returns the common area with another rectangle. */
        long common(Bounds other) {
            long across = Math.min(x + width, other.x + other.width) - Math.max(x, other.x);
            long down = Math.min(y + height, other.y + other.height) - Math.max(y, other.y);
            return Math.max(0, across) * Math.max(0, down);
        }
    }

    WindowPlace(long handle) {
        this.handle = handle;
    }

    WindowMode mode() {
        return mode;
    }

    /**
     * Changes the kind of window, on the screen that it is on.
     *
     * @param size of a free window, or of the picture of a full screen; {@code null} to keep the window's, or for the
     *     screen's own
     */
    void become(WindowMode next, Size size) {
        long screen = screen();
        GLFWVidMode video = screen == NULL ? null : glfwGetVideoMode(screen);
        if (video == null) {
            return;
        }
        if (mode == WindowMode.WINDOWED) {
            free = bounds();
        }
        if (mode != WindowMode.FULLSCREEN) {
            desktop = boundsOf(screen, video);
        }
        switch (next) {
            case WINDOWED -> becomeFree(size);
            case BORDERLESS -> {
                glfwSetWindowMonitor(handle, NULL, desktop.x, desktop.y, desktop.width, desktop.height, 0);
                glfwSetWindowAttrib(handle, GLFW_DECORATED, GLFW_FALSE);
                glfwSetWindowPos(handle, desktop.x, desktop.y);
                glfwSetWindowSize(handle, desktop.width, desktop.height);
            }
            case FULLSCREEN -> {
                int width = size == null ? desktop.width : size.width();
                int height = size == null ? desktop.height : size.height();
                glfwSetWindowMonitor(handle, screen, 0, 0, width, height, video.refreshRate());
            }
        }
        mode = next;
    }

    private void becomeFree(Size size) {
        int width = size == null ? free.width : size.width();
        int height = size == null ? free.height : size.height();
        glfwSetWindowAttrib(handle, GLFW_DECORATED, GLFW_TRUE);
        if (mode == WindowMode.WINDOWED) {
            glfwSetWindowSize(handle, width, height);
        } else {
            glfwSetWindowMonitor(handle, NULL, free.x, free.y, width, height, 0);
        }
    }

    /** Returns the screen that shows most of the window. */
    private long screen() {
        PointerBuffer screens = glfwGetMonitors();
        Bounds window = bounds();
        long most = -1;
        long best = NULL;
        for (int i = 0; screens != null && i < screens.limit(); i++) {
            GLFWVidMode video = glfwGetVideoMode(screens.get(i));
            long common = video == null ? -1 : boundsOf(screens.get(i), video).common(window);
            if (common > most) {
                most = common;
                best = screens.get(i);
            }
        }
        return best;
    }

    private static Bounds boundsOf(long screen, GLFWVidMode video) {
        int[] x = new int[1];
        int[] y = new int[1];
        glfwGetMonitorPos(screen, x, y);
        return new Bounds(x[0], y[0], video.width(), video.height());
    }

    private Bounds bounds() {
        int[] x = new int[1];
        int[] y = new int[1];
        int[] width = new int[1];
        int[] height = new int[1];
        glfwGetWindowPos(handle, x, y);
        glfwGetWindowSize(handle, width, height);
        return new Bounds(x[0], y[0], width[0], height[0]);
    }
}
