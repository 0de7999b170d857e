package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

import org.lwjgl.opengl.GL;

/** One OpenGL context, current on the thread that made it; every other object of this package takes it first. */
public final class GlContext implements AutoCloseable {
    private final Runnable destroy;
    private final GpuLimits limits;
    private final LiveObjects live = new LiveObjects();
    private final DrawState state = new DrawState();
    private final DebugMessages debug;

    private GlContext(Runnable destroy) {
        this.destroy = destroy;
        this.limits = GpuLimits.ofCurrent();
        this.debug = DebugMessages.listen(limits);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    }

    /**
     * A context without any window system. It has no default framebuffer: draw to a {@link RenderTarget}.
     *
     * @throws GlUnavailableException where EGL or OpenGL 4.1 is missing
     */
    public static GlContext offscreen() {
        OffscreenContext egl = OffscreenContext.makeCurrent();
        GL.createCapabilities(true);
        return new GlContext(egl::destroy);
    }

    /**
     * Loads the libraries that {@link #offscreen} needs by making a context and throwing it away: on another thread it
     * costs nothing while the level is read. Nothing fails here; the real context will say what is missing.
     */
    public static void preloadOffscreen() {
        try {
            OffscreenContext.makeCurrent().destroy();
        } catch (GlUnavailableException | LinkageError missing) {
            return;
        }
    }

    /** Wraps the context that the caller, a window, has made current and will destroy after this is closed. */
    public static GlContext ofCurrentWindow() {
        GL.createCapabilities(true);
        return new GlContext(() -> {});
    }

    public GpuLimits limits() {
        return limits;
    }

    public LiveObjects live() {
        return live;
    }

    public DrawState state() {
        return state;
    }

    Bindings bindings() {
        return state.bindings();
    }

    /** Waits until everything submitted is drawn: the end of a timed frame. */
    public void finish() {
        glFinish();
    }

    /** @throws GlException naming {@code doing} when OpenGL has recorded an error since the last call */
    public void requireNoError(String doing) {
        int error = glGetError();
        if (error != GL_NO_ERROR) {
            throw new GlException(doing + ": OpenGL error 0x" + Integer.toHexString(error));
        }
    }

    @Override
    public void close() {
        debug.close();
        GL.setCapabilities(null);
        destroy.run();
    }
}
