package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

import nephele.engine.render.gl.shader.GlException;
import nephele.engine.render.gl.shader.LinkedPrograms;
import org.lwjgl.opengl.GL;

/** One OpenGL context, current on the thread that made it; every other object of this package takes it first. */
public final class GlContext implements AutoCloseable {
    private final Runnable destroy;
    private final GpuLimits limits;
    private final LiveObjects live = new LiveObjects();
    private final LinkedPrograms programs = new LinkedPrograms();
    private final SharedObjects shared = new SharedObjects();
    private final DrawState state = new DrawState();
    private final DebugMessages debug;

    private GlContext(Runnable destroy) {
        this.destroy = destroy;
        this.limits = GpuLimits.ofCurrent();
        this.debug = DebugMessages.listen(limits);
        setForAll();
    }

    /** What is the same for everything that is drawn. */
    private static void setForAll() {
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
        glClearDepth(1);
        glClearStencil(0);
        glStencilMask(0xff);
    }

    /**
     * A context without any window system. It has no default framebuffer: draw to a {@link RenderTarget}.
     *
     * @throws GlUnavailableException where EGL or OpenGL 4.1 is missing
     */
    public static GlContext offscreen() {
        OffscreenContext egl = OffscreenContext.makeCurrent();
        GL.createCapabilities(true);
        return new GlContext(() -> {
            GL.setCapabilities(null);
            egl.destroy();
        });
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

    /**
     * Adopts the context that somebody else, a window or another toolkit, has made current, and will destroy after this is
     * closed.
     *
     * @throws IllegalStateException where no context is current
     */
    public static GlContext ofCurrent() {
        GL.createCapabilities(true);
        GlContext adopted = new GlContext(() -> {});
        adopted.state.assumeNothing();
        return adopted;
    }

    /** Takes an adopted context up again: from here on nothing that somebody else may have set is relied upon. */
    public void resume() {
        setForAll();
        state.assumeNothing();
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

    /** What several renderers of this context may share. */
    public SharedObjects shared() {
        return shared;
    }

    LinkedPrograms programs() {
        return programs;
    }

    Bindings bindings() {
        return state.bindings();
    }

    /** Waits until everything submitted is drawn: the end of a timed frame. */
    public void finish() {
        glFinish();
    }

    /** @throws nephele.engine.render.gl.shader.GlException naming {@code doing} when OpenGL has recorded an error since the last call */
    public void requireNoError(String doing) {
        int error = glGetError();
        if (error != GL_NO_ERROR) {
            throw new GlException(doing + ": OpenGL error 0x" + Integer.toHexString(error));
        }
    }

    @Override
    public void close() {
        programs.close();
        debug.close();
        destroy.run();
    }
}
