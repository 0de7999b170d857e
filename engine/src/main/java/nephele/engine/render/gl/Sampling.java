package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

/** Filtering and wrapping of a texture. */
public enum Sampling {
    /** Trilinear, anisotropic where present, repeating. */
    MIPMAPPED_REPEAT(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT),
    /** Trilinear, without repeats; for pictures with a border. */
    MIPMAPPED_CLAMP(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE),
    /** Linear without mipmaps, repeating along every axis; for tiles of noise. */
    LINEAR_REPEAT(GL_LINEAR, GL_LINEAR, GL_REPEAT),
    LINEAR_CLAMP(GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE),
    NEAREST_CLAMP(GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE),
    /** Compares with a reference depth and filters the four results: {@code sampler2DArrayShadow}. */
    SHADOW_COMPARE(GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE);

    final int minify;
    final int magnify;
    final int wrap;

    Sampling(int minify, int magnify, int wrap) {
        this.minify = minify;
        this.magnify = magnify;
        this.wrap = wrap;
    }

    boolean isMipmapped() {
        return this == MIPMAPPED_REPEAT || this == MIPMAPPED_CLAMP;
    }

    void apply(int target) {
        glTexParameteri(target, GL_TEXTURE_MIN_FILTER, minify);
        glTexParameteri(target, GL_TEXTURE_MAG_FILTER, magnify);
        glTexParameteri(target, GL_TEXTURE_WRAP_S, wrap);
        glTexParameteri(target, GL_TEXTURE_WRAP_T, wrap);
        glTexParameteri(target, GL_TEXTURE_WRAP_R, target == GL_TEXTURE_3D ? wrap : GL_CLAMP_TO_EDGE);
        if (this == SHADOW_COMPARE) {
            glTexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
            glTexParameteri(target, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
        }
    }
}
