package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

/** The storage format of a texel, and the format of its transfer. */
public enum PixelFormat {
    /** Colour in sRGB, decoded to linear when sampled; alpha is linear. */
    SRGB8_ALPHA8(GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE),
    RGBA8(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE),
    R8(GL_R8, GL_RED, GL_UNSIGNED_BYTE),
    R16(GL_R16, GL_RED, GL_UNSIGNED_SHORT),
    RG16(GL_RG16, GL_RG, GL_UNSIGNED_SHORT),
    R32F(GL_R32F, GL_RED, GL_FLOAT),
    RGBA16F(GL_RGBA16F, GL_RGBA, GL_FLOAT),
    RGBA32F(GL_RGBA32F, GL_RGBA, GL_FLOAT),
    DEPTH24(GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT),
    /** Depth, and eight bits of stencil that count the openings through which a pixel is seen. */
    DEPTH24_STENCIL8(GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8),
    DEPTH32F(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT);

    final int internal;
    final int pixels;
    final int type;

    PixelFormat(int internal, int pixels, int type) {
        this.internal = internal;
        this.pixels = pixels;
        this.type = type;
    }

    boolean isDepth() {
        return pixels == GL_DEPTH_COMPONENT;
    }
}
