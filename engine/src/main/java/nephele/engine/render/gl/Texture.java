package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

import java.nio.ByteBuffer;
import nephele.engine.render.gl.shader.TextureUnit;

/** A texture of one size and format: flat, an array of layers, a cube of six faces, or a volume of slices. */
public final class Texture implements GlObject {
    private static final int TEXTURE_MAX_ANISOTROPY = 0x84FE;

    /** The addressing of a texture's images. */
    public enum Shape {
        FLAT(GL_TEXTURE_2D),
        ARRAY(GL_TEXTURE_2D_ARRAY),
        CUBE(GL_TEXTURE_CUBE_MAP),
        /** Filtered between its slices too. */
        VOLUME(GL_TEXTURE_3D);

        private final int target;

        Shape(int target) {
            this.target = target;
        }
    }

    /** The texels of one layer, and the number of layers or slices. */
    public record Extent(int width, int height, int layers) {
        /** Returns the extent of a texture with one layer. */
        public static Extent flat(int width, int height) {
            return new Extent(width, height, 1);
        }
    }

    /** A rectangle of texels from {@code x}, {@code y} on. */
    public record Region(int x, int y, int width, int height) {}

    private final GlContext gl;
    private final GlHandle handle;
    private final Shape shape;
    private final PixelFormat format;
    private final Extent extent;
    private final Sampling sampling;

    /** Allocates storage without content. */
    public Texture(GlContext gl, String name, Shape shape, PixelFormat format, Extent extent, Sampling sampling) {
        requireFits(gl.limits(), name, shape, extent);
        this.gl = gl;
        this.shape = shape;
        this.format = format;
        this.extent = extent;
        this.sampling = sampling;
        handle = new GlHandle(gl, GlKind.TEXTURE, name, glGenTextures(), id -> glDeleteTextures(id));
        bind(TextureUnit.UPLOAD);
        sampling.apply(shape.target);
        if (!sampling.isMipmapped()) {
            glTexParameteri(shape.target, GL_TEXTURE_MAX_LEVEL, 0);
        }
        allocate();
        gl.live().stored(bytes());
    }

    private static void requireFits(GpuLimits limits, String name, Shape shape, Extent extent) {
        boolean isVolume = shape == Shape.VOLUME;
        int side = isVolume ? limits.maxVolumeSize() : limits.maxTextureSize();
        int layers = isVolume ? side : limits.maxArrayLayers();
        if (Math.max(extent.width, extent.height) > side || extent.layers > layers) {
            throw new GlUnavailableException(name + " requires a texture of " + extent.width + "x" + extent.height + "x"
                    + extent.layers + "; this machine allows " + side + " and " + layers + " layers");
        }
    }

    private void allocate() {
        ByteBuffer none = null;
        switch (shape) {
            case FLAT ->
                glTexImage2D(
                        GL_TEXTURE_2D,
                        0,
                        format.internal,
                        extent.width,
                        extent.height,
                        0,
                        format.pixels,
                        format.type,
                        none);
            case ARRAY, VOLUME -> allocateLayers(none);
            case CUBE -> {
                for (int face = 0; face < 6; face++) {
                    int target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + face;
                    glTexImage2D(
                            target,
                            0,
                            format.internal,
                            extent.width,
                            extent.height,
                            0,
                            format.pixels,
                            format.type,
                            none);
                }
            }
        }
    }

    private void allocateLayers(ByteBuffer none) {
        for (int level = 0; level < levels(); level++) {
            glTexImage3D(
                    shape.target,
                    level,
                    format.internal,
                    Math.max(extent.width >> level, 1),
                    Math.max(extent.height >> level, 1),
                    shape == Shape.VOLUME ? Math.max(extent.layers >> level, 1) : extent.layers,
                    0,
                    format.pixels,
                    format.type,
                    none);
        }
    }

    /** Returns 1, or the number of mipmap levels down to a single texel. */
    private int levels() {
        int side = Math.max(extent.width, extent.height);
        int largest = shape == Shape.VOLUME ? Math.max(side, extent.layers) : side;
        return sampling.isMipmapped() ? 32 - Integer.numberOfLeadingZeros(largest) : 1;
    }

    private long bytes() {
        long bytes = 0;
        for (int level = 0; level < levels(); level++) {
            long texels = (long) Math.max(extent.width >> level, 1) * Math.max(extent.height >> level, 1);
            int layers = shape == Shape.VOLUME ? Math.max(extent.layers >> level, 1) : extent.layers;
            bytes += format.bytes * texels * (shape == Shape.CUBE ? 6 : layers);
        }
        return bytes;
    }

    /** Replaces one layer, slice or cube face; the first row is at t = 0. {@code texels} is a direct buffer. */
    public void upload(int layer, ByteBuffer texels) {
        upload(layer, new Region(0, 0, extent.width, extent.height), texels);
    }

    /** Replaces a part of one layer, slice or cube face; {@code texels} holds the part's rows, one after another. */
    public void upload(int layer, Region part, ByteBuffer texels) {
        bind(TextureUnit.UPLOAD);
        if (hasLayers()) {
            glTexSubImage3D(
                    shape.target,
                    0,
                    part.x,
                    part.y,
                    layer,
                    part.width,
                    part.height,
                    1,
                    format.pixels,
                    format.type,
                    texels);
        } else {
            int target = shape == Shape.CUBE ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + layer : shape.target;
            glTexSubImage2D(target, 0, part.x, part.y, part.width, part.height, format.pixels, format.type, texels);
        }
    }

    private boolean hasLayers() {
        return shape == Shape.ARRAY || shape == Shape.VOLUME;
    }

    /** Takes over the texels of another flat texture of the same size and a format that can be drawn to. */
    public void copyFrom(Texture other) {
        int before = glGetInteger(GL_READ_FRAMEBUFFER_BINDING);
        int reading = glGenFramebuffers();
        glBindFramebuffer(GL_READ_FRAMEBUFFER, reading);
        glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, other.handle.id(), 0);
        bind(TextureUnit.UPLOAD);
        glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, extent.width, extent.height);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, before);
        glDeleteFramebuffers(reading);
    }

    /** Generates the mipmap levels of a flat texture or volume from the largest. */
    public void generateLevels() {
        bind(TextureUnit.UPLOAD);
        glGenerateMipmap(shape.target);
    }

    /**
     * Replaces a mipmap level of one layer of an array; level 1 has half the side lengths, rounded down, at least 1.
     */
    public void uploadLevel(int level, int layer, ByteBuffer texels) {
        bind(TextureUnit.UPLOAD);
        int width = Math.max(extent.width >> level, 1);
        int height = Math.max(extent.height >> level, 1);
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, level, 0, 0, layer, width, height, 1, format.pixels, format.type, texels);
    }

    /** Sets the greatest number of samples across a slanted surface, if the driver supports it. */
    public void anisotropy(float most) {
        if (gl.limits().maxAnisotropy() > 1) {
            bind(TextureUnit.UPLOAD);
            float level = Math.min(most, gl.limits().maxAnisotropy());
            glTexParameterf(shape.target, TEXTURE_MAX_ANISOTROPY, Math.max(1, level));
        }
    }

    /** Binds the texture to a unit for the following draws. */
    public void bind(TextureUnit unit) {
        gl.bindings().texture(unit, shape.target, handle.id());
    }

    public Extent extent() {
        return extent;
    }

    public PixelFormat format() {
        return format;
    }

    public Sampling sampling() {
        return sampling;
    }

    Shape shape() {
        return shape;
    }

    int id() {
        return handle.id();
    }

    @Override
    public void close() {
        handle.close();
        gl.live().stored(-bytes());
    }
}
