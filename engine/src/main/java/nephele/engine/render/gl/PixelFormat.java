package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

/** The storage format of a texel, and the format of its transfer. */
public enum PixelFormat {
    /** Colour in sRGB, decoded to linear when sampled; alpha is linear. */
    SRGB8_ALPHA8(GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE, 4),
    RGBA8(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4),
    R8(GL_R8, GL_RED, GL_UNSIGNED_BYTE, 1),
    RG8(GL_RG8, GL_RG, GL_UNSIGNED_BYTE, 2),
    R16(GL_R16, GL_RED, GL_UNSIGNED_SHORT, 2),
    RG16(GL_RG16, GL_RG, GL_UNSIGNED_SHORT, 4),
    R32F(GL_R32F, GL_RED, GL_FLOAT, 4),
    RG16F(GL_RG16F, GL_RG, GL_FLOAT, 4),
    RG32F(GL_RG32F, GL_RG, GL_FLOAT, 8),
    /** Three positive numbers with a common exponent, filtered like others; shaders cannot draw to it. */
    RGB9_E5(GL_RGB9_E5, GL_RGB, GL_UNSIGNED_INT_5_9_9_9_REV, 4),
    RGBA16F(GL_RGBA16F, GL_RGBA, GL_FLOAT, 8),
    RGBA32F(GL_RGBA32F, GL_RGBA, GL_FLOAT, 16),
    DEPTH24(GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 4),
    /** Depth, and eight bits of stencil that count the openings through which a pixel is seen. */
    DEPTH24_STENCIL8(GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, 4),
    DEPTH32F(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 4);

    final int internal;
    final int pixels;
    final int type;
    /** The size of a texel in graphics memory, bytes. */
    final int bytes;

    PixelFormat(int internal, int pixels, int type, int bytes) {
        this.internal = internal;
        this.pixels = pixels;
        this.type = type;
        this.bytes = bytes;
    }

    boolean isDepth() {
        return pixels == GL_DEPTH_COMPONENT;
    }
}
