package nephele.engine.render.gl;

import static org.lwjgl.glfw.GLFW.*;

import org.lwjgl.system.Configuration;
import org.lwjgl.system.Platform;

/**
 * The context of a window that is never shown: OpenGL without a visible window where there is no EGL, on Windows and
 * macOS.
 */
record HiddenWindowContext(long window) {
    private static final int SIDE_PIXELS = 16;

    static HiddenWindowContext makeCurrent() {
        if (Platform.get() == Platform.MACOSX) {
            // The window toolkit of Java has the first thread; GLFW draws on another one if it opens nothing visible.
            Configuration.GLFW_CHECK_THREAD0.set(false);
        }
        if (!glfwInit()) {
            throw new GlUnavailableException("Offscreen rendering requires a desktop session; there is none.");
        }
        glfwDefaultWindowHints();
        glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        long window = glfwCreateWindow(SIDE_PIXELS, SIDE_PIXELS, "", 0, 0);
        if (window == 0) {
            throw new GlUnavailableException("Offscreen rendering requires OpenGL 4.1: update the graphics driver.");
        }
        glfwMakeContextCurrent(window);
        return new HiddenWindowContext(window);
    }

    /** Destroys the window and its context; GLFW stays initialised for other windows of the process. */
    void destroy() {
        glfwMakeContextCurrent(0);
        glfwDestroyWindow(window);
    }
}
