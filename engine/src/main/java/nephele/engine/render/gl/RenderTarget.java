package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import org.lwjgl.BufferUtils;

/** Where a pass draws: an offscreen picture with its own textures, one layer of a depth array, or the window. */
public final class RenderTarget implements AutoCloseable {
    private final GlContext gl;
    private final GlHandle framebuffer;
    private final GlHandle depth;
    private final Texture colour;
    private final GlHandle colourSamples;
    private final int width;
    private final int height;

    private RenderTarget(GlContext gl, GlHandle framebuffer, GlHandle depth, Texture colour, int width, int height) {
        this(gl, framebuffer, depth, colour, null, width, height);
    }

    private RenderTarget(
            GlContext gl,
            GlHandle framebuffer,
            GlHandle depth,
            Texture colour,
            GlHandle colourSamples,
            int width,
            int height) {
        this.gl = gl;
        this.framebuffer = framebuffer;
        this.depth = depth;
        this.colour = colour;
        this.colourSamples = colourSamples;
        this.width = width;
        this.height = height;
    }

    /** Colour texture of the given format, 24 bits of depth and 8 of stencil. */
    public static RenderTarget picture(GlContext gl, String name, PixelFormat format, int width, int height) {
        return picture(gl, name, format, width, height, Sampling.NEAREST_CLAMP);
    }

    /** As {@link #picture(GlContext, String, PixelFormat, int, int)}, to be looked up in some other way. */
    public static RenderTarget picture(
            GlContext gl, String name, PixelFormat format, int width, int height, Sampling sampling) {
        Texture colour =
                new Texture(gl, name, Texture.Shape.FLAT, format, Texture.Extent.flat(width, height), sampling);
        GlHandle depth =
                new GlHandle(gl, GlKind.RENDERBUFFER, name, glGenRenderbuffers(), id -> glDeleteRenderbuffers(id));
        glBindRenderbuffer(GL_RENDERBUFFER, depth.id());
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, width, height);
        GlHandle framebuffer = newFramebuffer(gl, name);
        gl.bindings().framebuffer(framebuffer.id(), width, height);
        glFramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, colour.id(), 0);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth.id());
        return complete(name, new RenderTarget(gl, framebuffer, depth, colour, width, height));
    }

    /**
     * Colour, depth and stencil with several samples a pixel, to be drawn into and then {@link #copyTo copied}.
     *
     * @return {@code null} where this OpenGL cannot draw into such a target
     */
    public static RenderTarget multisampled(GlContext gl, PixelFormat format, int width, int height, int samples) {
        GlHandle colour = newSamples(gl, format, width, height, samples);
        GlHandle depth = newSamples(gl, PixelFormat.DEPTH24_STENCIL8, width, height, samples);
        GlHandle framebuffer = newFramebuffer(gl, "multisampled surface");
        gl.bindings().framebuffer(framebuffer.id(), width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour.id());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth.id());
        RenderTarget target = new RenderTarget(gl, framebuffer, depth, null, colour, width, height);
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
            target.close();
            return null;
        }
        return target;
    }

    private static GlHandle newSamples(GlContext gl, PixelFormat format, int width, int height, int samples) {
        GlHandle handle =
                new GlHandle(gl, GlKind.RENDERBUFFER, "samples", glGenRenderbuffers(), id -> glDeleteRenderbuffers(id));
        glBindRenderbuffer(GL_RENDERBUFFER, handle.id());
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format.internal, width, height);
        return handle;
    }

    /** Depth only, into one layer of a depth array that stays the caller's. */
    public static RenderTarget depthLayer(GlContext gl, String name, Texture depthArray, int layer) {
        GlHandle framebuffer = newFramebuffer(gl, name);
        Texture.Extent extent = depthArray.extent();
        gl.bindings().framebuffer(framebuffer.id(), extent.width(), extent.height());
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, depthArray.id(), 0, layer);
        glDrawBuffer(GL_NONE);
        glReadBuffer(GL_NONE);
        return complete(name, new RenderTarget(gl, framebuffer, null, null, extent.width(), extent.height()));
    }

    /** The window's own framebuffer, 8 bits a channel with depth. */
    public static RenderTarget window(GlContext gl, int width, int height) {
        return new RenderTarget(gl, null, null, null, width, height);
    }

    private static GlHandle newFramebuffer(GlContext gl, String name) {
        return new GlHandle(gl, GlKind.FRAMEBUFFER, name, glGenFramebuffers(), id -> glDeleteFramebuffers(id));
    }

    /** The bound target itself; one that cannot be drawn into is closed before this fails. */
    private static RenderTarget complete(String name, RenderTarget target) {
        int status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
        if (status != GL_FRAMEBUFFER_COMPLETE) {
            target.close();
            throw new GlException(name + ": framebuffer incomplete, 0x" + Integer.toHexString(status));
        }
        return target;
    }

    public int width() {
        return width;
    }

    public int height() {
        return height;
    }

    /** What was drawn, for a later pass to sample; {@code null} for the window and for depth layers. */
    public Texture colour() {
        return colour;
    }

    /** All drawing goes here from now on. */
    public void bind() {
        gl.bindings().framebuffer(framebuffer == null ? 0 : framebuffer.id(), width, height);
    }

    /** Binds, sets every colour to the given one, every depth to the farthest and every stencil to 0. */
    public void clear(float red, float green, float blue) {
        gl.state().noScissor();
        clearWithinScissor(red, green, blue);
    }

    /** As {@link #clear}, only where the scissor lets through. */
    public void clearWithinScissor(float red, float green, float blue) {
        bind();
        gl.state().allowDepthClear();
        if (gl.state().listener() != null) {
            gl.state().listener().cleared(new float[] {red, green, blue, 1});
        }
        glClearColor(red, green, blue, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }

    /** Binds and sets every depth to the farthest. */
    public void clearDepth() {
        bind();
        gl.state().noScissor();
        gl.state().allowDepthClear();
        if (gl.state().listener() != null) {
            gl.state().listener().cleared(null);
        }
        glClear(GL_DEPTH_BUFFER_BIT);
    }

    /**
     * Copies the colours to a target of the same size, averaging the samples of a pixel, and binds that. From samples
     * only to a {@link #picture} of the same format: a window's own format is not known.
     */
    public void copyTo(RenderTarget target) {
        target.bind();
        int from = framebuffer == null ? 0 : framebuffer.id();
        int to = target.framebuffer == null ? 0 : target.framebuffer.id();
        if (gl.state().listener() != null) {
            gl.state().listener().copied(from, to, width, height);
        }
        copyColours(from, to, width, height);
    }

    /** Leaves {@code to} bound for reading too, as {@link #bind} does. */
    static void copyColours(int from, int to, int width, int height) {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
        glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, to);
    }

    /** RGBA bytes, the bottom row first. */
    public ByteBuffer readBytes() {
        ByteBuffer bytes = BufferUtils.createByteBuffer(4 * width * height);
        bind();
        glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
        return bytes;
    }

    /** Linear RGB floats, the bottom row first. */
    public float[] readFloats() {
        float[] rgb = new float[3 * width * height];
        bind();
        glReadPixels(0, 0, width, height, GL_RGB, GL_FLOAT, rgb);
        return rgb;
    }

    /** Window depth 0–1, the bottom row first. */
    public float[] readDepth() {
        FloatBuffer depths = BufferUtils.createFloatBuffer(width * height);
        bind();
        glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
        float[] copy = new float[depths.capacity()];
        depths.get(copy);
        return copy;
    }

    @Override
    public void close() {
        if (framebuffer != null) {
            framebuffer.close();
        }
        if (depth != null) {
            depth.close();
        }
        if (colour != null) {
            colour.close();
        }
        if (colourSamples != null) {
            colourSamples.close();
        }
    }
}
