package nephele.engine.render.gl;

import static org.lwjgl.glfw.GLFW.*;
import static org.lwjgl.opengl.GL11C.glEnable;
import static org.lwjgl.opengl.GL41C.*;
import static org.lwjgl.opengl.KHRDebug.*;

import nephele.engine.render.gl.shader.GlException;
import nephele.engine.render.gl.shader.LinkedPrograms;
import nephele.engine.work.SwingThread;
import org.lwjgl.opengl.GL;
import org.lwjgl.opengl.GLDebugMessageCallback;
import org.lwjgl.system.Configuration;
import org.lwjgl.system.Platform;

/** One OpenGL context, current on the thread that made it; the first argument of every other object of this package. */
public final class GlContext implements AutoCloseable {
    /** Property that enables the driver's messages; they cost start-up time and synchronise every call. */
    private static final String DEBUG_PROPERTY = "nephele.gl.debug";

    private static final int SIDE_PIXELS = 16;

    private final Runnable destroy;
    private final GpuLimits limits;
    private final LiveObjects live = new LiveObjects();
    private final LinkedPrograms programs = new LinkedPrograms();
    private final SharedObjects shared = new SharedObjects();
    private final DrawState state = new DrawState();
    /** {@code null} unless {@link #DEBUG_PROPERTY} is set and the driver has messages. */
    private final GLDebugMessageCallback messages;

    private GlContext(Runnable destroy) {
        SwingThread.refuse("drawing");
        this.destroy = destroy;
        this.limits = GpuLimits.ofCurrent();
        this.messages = limits.debugMessages() && Boolean.getBoolean(DEBUG_PROPERTY) ? forwardMessages() : null;
        setForAll();
    }

    /** Forwards the driver's serious messages to standard error. */
    private static GLDebugMessageCallback forwardMessages() {
        GLDebugMessageCallback callback =
                GLDebugMessageCallback.create((source, type, id, severity, length, message, user) -> {
                    if (severity == GL_DEBUG_SEVERITY_HIGH || type == GL_DEBUG_TYPE_ERROR) {
                        System.err.println("OpenGL: " + GLDebugMessageCallback.getMessage(length, message));
                    }
                });
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(callback, 0);
        return callback;
    }

    /** Sets the state that is the same for all drawing. */
    private static void setForAll() {
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
        glClearDepth(1);
        glClearStencil(0);
        glStencilMask(0xff);
    }

    /**
     * Creates a context for drawing to a {@link RenderTarget} only. On Linux it needs no window system; on Windows and
     * macOS it is that of a hidden window, which needs a desktop session.
     *
     * @throws GlUnavailableException if EGL, the session or OpenGL 4.1 is missing
     */
    public static GlContext offscreen() {
        return hasNoEgl() ? ofHiddenWindow() : ofEgl();
    }

    private static boolean hasNoEgl() {
        return Platform.get() == Platform.WINDOWS || Platform.get() == Platform.MACOSX;
    }

    private static GlContext ofEgl() {
        return of(OffscreenContext.makeCurrent()::destroy);
    }

    /** Creates a context as {@link #offscreen} does where there is no EGL; needs a desktop session. */
    static GlContext ofHiddenWindow() {
        long window = hiddenWindow();
        // GLFW stays initialised for other windows of the process.
        return of(() -> {
            glfwMakeContextCurrent(0);
            glfwDestroyWindow(window);
        });
    }

    /** Returns the current window, which is never shown. */
    private static long hiddenWindow() {
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
        return window;
    }

    private static GlContext of(Runnable destroyContext) {
        GL.createCapabilities(true);
        return new GlContext(() -> {
            GL.setCapabilities(null);
            destroyContext.run();
        });
    }

    /**
     * Loads the libraries that {@link #offscreen} needs by creating and destroying a context; run on another thread,
     * this costs no time while the level is read. Never fails; the real context reports what is missing.
     */
    public static void preloadOffscreen() {
        if (hasNoEgl()) {
            return;
        }
        try {
            OffscreenContext.makeCurrent().destroy();
        } catch (GlUnavailableException | LinkageError missing) {
            return;
        }
    }

    /**
     * Adopts the current context of a window, which destroys it after this object is closed; assumes nothing about its
     * state.
     *
     * @throws IllegalStateException if no context is current
     */
    public static GlContext ofCurrent() {
        GL.createCapabilities(true);
        GlContext adopted = new GlContext(() -> {});
        adopted.state.assumeNothing();
        return adopted;
    }

    /** Returns the capabilities of this context. */
    public GpuLimits limits() {
        return limits;
    }

    public LiveObjects live() {
        return live;
    }

    /** Returns the draw state, the only object that sets it. */
    public DrawState state() {
        return state;
    }

    /** Returns the objects that several renderers of this context can share. */
    public SharedObjects shared() {
        return shared;
    }

    LinkedPrograms programs() {
        return programs;
    }

    Bindings bindings() {
        return state.bindings();
    }

    /** Waits until all submitted work is complete: the end of a timed frame. */
    public void finish() {
        glFinish();
    }

    /**
     * Throws if OpenGL has recorded an error since the last call.
     *
     * @param doing the activity, for the message
     * @throws GlException that names {@code doing}
     */
    public void requireNoError(String doing) {
        int error = glGetError();
        if (error != GL_NO_ERROR) {
            throw new GlException(doing + ": OpenGL error 0x" + Integer.toHexString(error));
        }
    }

    @Override
    public void close() {
        programs.close();
        if (messages != null) {
            glDebugMessageCallback(null, 0);
            messages.free();
        }
        destroy.run();
    }
}
