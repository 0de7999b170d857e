package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.List;
import nephele.engine.render.gl.shader.GlException;
import org.lwjgl.BufferUtils;

/** The target of a pass: an offscreen picture with its own textures, one layer of a texture, or the window. */
public final class RenderTarget implements GlObject {
    /** The greatest number of positions of samples that are known. */
    private static final int MOST_POSITIONS = 8;

    private final GlContext gl;
    private final GlHandle framebuffer;
    private final Texture colour;
    private final Texture second;
    private final Texture depth;
    /** Attachments that are drawn into but never sampled. */
    private final List<GlHandle> renderbuffers;

    private final PixelFormat format;
    private final int width;
    private final int height;

    private RenderTarget(GlContext gl, GlHandle framebuffer, Attachments attached, int width, int height) {
        this.gl = gl;
        this.framebuffer = framebuffer;
        this.colour = attached.colour;
        this.second = attached.second;
        this.depth = attached.depth;
        this.renderbuffers = attached.renderbuffers;
        this.format = attached.format;
        this.width = width;
        this.height = height;
    }

    /** The attachments that a target owns; {@code format} is that of its colours. */
    private record Attachments(
            PixelFormat format, Texture colour, Texture second, Texture depth, List<GlHandle> renderbuffers) {}

    /** Creates a target with a colour texture of the given format, 24 bits of depth and 8 of stencil. */
    public static RenderTarget picture(GlContext gl, String name, PixelFormat format, int width, int height) {
        return picture(gl, name, format, width, height, Sampling.NEAREST_CLAMP);
    }

    /**
     * Creates a picture with a fraction of this target's pixels along each side, rounded up, for layers that are drawn
     * at low resolution and composited with linear filtering.
     *
     * @param divisor 2 for half, 4 for a quarter of the pixels along a side
     */
    public RenderTarget reduced(String name, PixelFormat itsFormat, int divisor) {
        int itsWidth = Math.max(1, (width + divisor - 1) / divisor);
        int itsHeight = Math.max(1, (height + divisor - 1) / divisor);
        return picture(gl, name, itsFormat, itsWidth, itsHeight, Sampling.LINEAR_CLAMP);
    }

    /** Creates a target as {@link #picture(GlContext, String, PixelFormat, int, int)} does, with other sampling. */
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
        Attachments attached = new Attachments(format, colour, null, null, List.of(depth));
        return complete(name, new RenderTarget(gl, framebuffer, attached, width, height));
    }

    /** Creates a target of two colour textures, without depth: shaders write locations 0 and 1; draw state is of both. */
    public static RenderTarget pair(
            GlContext gl, String name, PixelFormat format, int width, int height, Sampling sampling) {
        return pair(gl, name, format, format, width, height, sampling);
    }

    /** Creates a pair as {@link #pair(GlContext, String, PixelFormat, int, int, Sampling)} does, of two formats. */
    public static RenderTarget pair(
            GlContext gl,
            String name,
            PixelFormat format,
            PixelFormat secondFormat,
            int width,
            int height,
            Sampling sampling) {
        Texture.Extent extent = Texture.Extent.flat(width, height);
        Texture first = new Texture(gl, name, Texture.Shape.FLAT, format, extent, sampling);
        Texture second = new Texture(gl, name, Texture.Shape.FLAT, secondFormat, extent, sampling);
        GlHandle framebuffer = newFramebuffer(gl, name);
        gl.bindings().framebuffer(framebuffer.id(), width, height);
        glFramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, first.id(), 0);
        glFramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, second.id(), 0);
        glDrawBuffers(new int[] {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1});
        Attachments attached = new Attachments(format, first, second, null, List.of());
        return complete(name, new RenderTarget(gl, framebuffer, attached, width, height));
    }

    /**
     * Creates a target whose depth can be sampled, as destination of {@link #copyTo copies}.
     *
     * @param format format of its colours; {@code null} for none
     */
    public static RenderTarget readable(GlContext gl, String name, PixelFormat format, int width, int height) {
        Texture colour = format == null ? null : flat(gl, name, format, width, height);
        Texture depth = flat(gl, name, PixelFormat.DEPTH24_STENCIL8, width, height);
        GlHandle framebuffer = newFramebuffer(gl, name);
        gl.bindings().framebuffer(framebuffer.id(), width, height);
        glFramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, depth.id(), 0);
        if (colour == null) {
            glDrawBuffer(GL_NONE);
            glReadBuffer(GL_NONE);
        } else {
            glFramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, colour.id(), 0);
        }
        Attachments attached = new Attachments(format, colour, null, depth, List.of());
        return complete(name, new RenderTarget(gl, framebuffer, attached, width, height));
    }

    private static Texture flat(GlContext gl, String name, PixelFormat format, int width, int height) {
        Texture.Extent extent = Texture.Extent.flat(width, height);
        return new Texture(gl, name, Texture.Shape.FLAT, format, extent, Sampling.NEAREST_CLAMP);
    }

    /**
     * Creates a target of colour, depth and stencil with several samples a pixel, as source of {@link #copyTo copies}.
     *
     * @return {@code null} if this OpenGL cannot draw into such a target
     */
    public static RenderTarget multisampled(GlContext gl, PixelFormat format, int width, int height, int samples) {
        GlHandle colour = newSamples(gl, format, width, height, samples);
        GlHandle depth = newSamples(gl, PixelFormat.DEPTH24_STENCIL8, width, height, samples);
        GlHandle framebuffer = newFramebuffer(gl, "multisampled surface");
        gl.bindings().framebuffer(framebuffer.id(), width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour.id());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth.id());
        Attachments attached = new Attachments(format, null, null, null, List.of(colour, depth));
        RenderTarget target = new RenderTarget(gl, framebuffer, attached, width, height);
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

    /** Creates a target of depth only: one layer of a depth array, which stays the caller's. */
    public static RenderTarget depthLayer(GlContext gl, String name, Texture depthArray, int layer) {
        GlHandle framebuffer = bindLayer(gl, name, depthArray, GL_DEPTH_ATTACHMENT, layer);
        glDrawBuffer(GL_NONE);
        glReadBuffer(GL_NONE);
        return ofLayer(gl, name, framebuffer, null, depthArray.extent());
    }

    /** Creates a target of colours only: one layer of an array or one slice of a volume, which stays the caller's. */
    public static RenderTarget colourLayer(GlContext gl, String name, Texture layers, int layer) {
        GlHandle framebuffer = bindLayer(gl, name, layers, GL_COLOR_ATTACHMENT0, layer);
        return ofLayer(gl, name, framebuffer, layers.format(), layers.extent());
    }

    /** Creates a target of some layers of an array, which stays the caller's: shaders write location n to the n-th of them. */
    public static RenderTarget colourLayers(GlContext gl, String name, Texture layers, int first, int count) {
        GlHandle framebuffer = bindLayer(gl, name, layers, GL_COLOR_ATTACHMENT0, first);
        int[] attachments = new int[count];
        for (int i = 0; i < count; i++) {
            attachments[i] = GL_COLOR_ATTACHMENT0 + i;
            glFramebufferTextureLayer(GL_FRAMEBUFFER, attachments[i], layers.id(), 0, first + i);
        }
        glDrawBuffers(attachments);
        return ofLayer(gl, name, framebuffer, layers.format(), layers.extent());
    }

    private static GlHandle bindLayer(GlContext gl, String name, Texture layers, int attachment, int layer) {
        GlHandle framebuffer = newFramebuffer(gl, name);
        gl.bindings()
                .framebuffer(
                        framebuffer.id(),
                        layers.extent().width(),
                        layers.extent().height());
        glFramebufferTextureLayer(GL_FRAMEBUFFER, attachment, layers.id(), 0, layer);
        return framebuffer;
    }

    private static RenderTarget ofLayer(
            GlContext gl, String name, GlHandle framebuffer, PixelFormat format, Texture.Extent extent) {
        Attachments attached = new Attachments(format, null, null, null, List.of());
        return complete(name, new RenderTarget(gl, framebuffer, attached, extent.width(), extent.height()));
    }

    /** Returns the window's own framebuffer, 8 bits a channel with depth. */
    public static RenderTarget window(GlContext gl, int width, int height) {
        Attachments attached = new Attachments(PixelFormat.RGBA8, null, null, null, List.of());
        return new RenderTarget(gl, null, attached, width, height);
    }

    private static GlHandle newFramebuffer(GlContext gl, String name) {
        return new GlHandle(gl, GlKind.FRAMEBUFFER, name, glGenFramebuffers(), id -> glDeleteFramebuffers(id));
    }

    /** Returns the bound target; closes it and throws if it is incomplete. */
    private static RenderTarget complete(String name, RenderTarget target) {
        int status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
        if (status != GL_FRAMEBUFFER_COMPLETE) {
            target.close();
            throw new GlException(name + ": framebuffer incomplete, 0x" + Integer.toHexString(status));
        }
        return target;
    }

    /** Returns the width in pixels. */
    public int width() {
        return width;
    }

    /** Returns the height in pixels. */
    public int height() {
        return height;
    }

    /**
     * Returns the colours for a later pass to sample; {@code null} for the window, multisampled targets, layers
     * and depth alone.
     */
    public Texture colour() {
        return colour;
    }

    /** Returns the second colours; {@code null} except for a {@link #pair}. */
    public Texture second() {
        return second;
    }

    /** Returns the depth to sample; {@code null} except for {@link #readable} targets. */
    public Texture depth() {
        return depth;
    }

    /** Returns the format of the colours: for the window nearly the system's, {@code null} for depth alone. */
    public PixelFormat format() {
        return format;
    }

    /** Returns true for the window's own framebuffer, whose depth cannot be copied. */
    public boolean isWindow() {
        return framebuffer == null;
    }

    /** Directs all further drawing here. */
    public void bind() {
        gl.bindings().framebuffer(framebuffer == null ? 0 : framebuffer.id(), width, height);
    }

    /** Binds, and sets every colour to the given one, every depth to the farthest and every stencil to 0. */
    public void clear(double red, double green, double blue) {
        clear(red, green, blue, 1);
    }

    /** Clears as {@link #clear(double, double, double)} does, with another alpha than 1. */
    public void clear(double red, double green, double blue, double alpha) {
        gl.state().noScissor();
        clearWithinScissor(red, green, blue, alpha);
    }

    /** Clears as {@link #clear(double, double, double, double)} does, to black with alpha 0, for layers that are composited later. */
    public void clearTransparent() {
        gl.state().noScissor();
        clearTo(0, 0, 0, 0);
    }

    /** Clears as {@link #clear(double, double, double, double)} does, within the scissor. */
    public void clearWithinScissor(double red, double green, double blue, double alpha) {
        clearTo((float) red, (float) green, (float) blue, (float) alpha);
    }

    /** Clears as {@link #clearTransparent} does, within the scissor. */
    public void clearTransparentWithinScissor() {
        clearTo(0, 0, 0, 0);
    }

    private void clearTo(float red, float green, float blue, float alpha) {
        bind();
        gl.state().allowDepthClear();
        if (gl.state().listener() != null) {
            gl.state().listener().cleared(new float[] {red, green, blue, alpha});
        }
        glClearColor(red, green, blue, alpha);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }

    /** Binds and sets every depth to the farthest. */
    public void clearDepth() {
        gl.state().noScissor();
        clearDepthWithinScissor();
    }

    /** Binds and sets the depths that the scissor leaves to the farthest. */
    public void clearDepthWithinScissor() {
        bind();
        gl.state().allowDepthClear();
        if (gl.state().listener() != null) {
            gl.state().listener().cleared(null);
        }
        glClear(GL_DEPTH_BUFFER_BIT);
    }

    /** Copies the colours as {@link #copyTo(RenderTarget, CopiedPlanes)} does. */
    public void copyTo(RenderTarget target) {
        copyTo(target, CopiedPlanes.COLOUR);
    }

    /**
     * Copies to a target of the same size, within the scissor, and binds it. The samples of a pixel become one: the
     * average of their colours, the depth of one of them. Multisampled colours can be copied only to a target of the
     * same format, and depth never from or to a window, whose formats are unknown.
     */
    public void copyTo(RenderTarget target, CopiedPlanes copied) {
        target.bind();
        int from = framebuffer == null ? 0 : framebuffer.id();
        int to = target.framebuffer == null ? 0 : target.framebuffer.id();
        if (gl.state().listener() != null) {
            gl.state().listener().copied(from, to, width, height, copied);
        }
        copyPixels(from, to, width, height, copied);
    }

    /**
     * Copies the colours to a place in another target, without the scissor, and binds it.
     *
     * @param x column of the target that receives the first one, {@code y} its row, from the bottom, for the bottom one
     */
    public void copyInto(RenderTarget target, int x, int y) {
        copyColours(target, new int[] {x, y, x + width, y + height}, GL_NEAREST);
    }

    /** Copies the colours over the whole of a target of another size, sampled bilinearly, without the scissor, and binds it. */
    public void copyScaledTo(RenderTarget target) {
        copyColours(target, new int[] {0, 0, target.width, target.height}, GL_LINEAR);
    }

    private void copyColours(RenderTarget target, int[] to, int filter) {
        target.bind();
        gl.state().noScissor();
        glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer == null ? 0 : framebuffer.id());
        glBlitFramebuffer(0, 0, width, height, to[0], to[1], to[2], to[3], CopiedPlanes.COLOUR.buffers, filter);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, target.framebuffer == null ? 0 : target.framebuffer.id());
    }

    /** Copies, and leaves {@code to} bound for reading too, as {@link #bind} does. */
    static void copyPixels(int from, int to, int width, int height, CopiedPlanes copied) {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
        glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, copied.buffers, GL_NEAREST);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, to);
    }

    /** Returns RGBA bytes, the bottom row first. */
    public ByteBuffer readBytes() {
        ByteBuffer bytes = BufferUtils.createByteBuffer(4 * width * height);
        bind();
        glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
        return bytes;
    }

    /**
     * Reads 0xAARRGGBB of each pixel, the bottom row first.
     *
     * @param pixels receives them; one element for each
     */
    public void readRgb(int[] pixels) {
        bind();
        glReadPixels(0, 0, width, height, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, pixels);
    }

    /** Returns linear RGB floats, the bottom row first. */
    public float[] readFloats() {
        float[] rgb = new float[3 * width * height];
        bind();
        glReadPixels(0, 0, width, height, GL_RGB, GL_FLOAT, rgb);
        return rgb;
    }

    /** Returns window depth 0–1, the bottom row first. */
    public float[] readDepth() {
        FloatBuffer depths = BufferUtils.createFloatBuffer(width * height);
        bind();
        glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
        float[] copy = new float[depths.capacity()];
        depths.get(copy);
        return copy;
    }

    /**
     * Returns x and y of each sample, pixels from the pixel's centre; the centre for one sample, or if this OpenGL cannot
     * draw into such a target.
     */
    public static float[] samplePositions(GlContext gl, int samples) {
        float[] positions = new float[2 * MOST_POSITIONS];
        RenderTarget target = samples <= 1 ? null : multisampled(gl, PixelFormat.RGBA8, 1, 1, samples);
        if (target != null) {
            target.bind();
            int known = Math.min(glGetInteger(GL_SAMPLES), MOST_POSITIONS);
            float[] position = new float[2];
            for (int i = 0; i < known; i++) {
                glGetMultisamplefv(GL_SAMPLE_POSITION, i, position);
                positions[2 * i] = position[0] - 0.5f;
                positions[2 * i + 1] = position[1] - 0.5f;
            }
            target.close();
        }
        return positions;
    }

    @Override
    public void close() {
        if (framebuffer != null) {
            framebuffer.close();
        }
        if (colour != null) {
            colour.close();
        }
        if (second != null) {
            second.close();
        }
        if (depth != null) {
            depth.close();
        }
        renderbuffers.forEach(GlHandle::close);
    }
}
