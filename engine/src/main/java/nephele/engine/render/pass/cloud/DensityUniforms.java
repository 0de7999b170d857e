package nephele.engine.render.pass.cloud;

import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;

/**
 * The uniforms with which a program finds the density of a cloud in its cells.
 *
 * @param phase {@code null} for a program that neither marches rays nor finds diffuse light
 */
public record DensityUniforms(BoxUniforms boxes, Uniforms.Vector4 medium, Uniforms.Vector4 phase) {
    /** Boxes that a cloud has at most; {@code MOST_BOXES} in shaders. */
    public static final int MOST_BOXES = 6;

    /** Finds the uniforms of a program and assigns its sampler. */
    public static DensityUniforms of(Uniforms uniforms) {
        return of(uniforms, uniforms.vector4("phase"));
    }

    /** Does the same for a program without {@code phase}. */
    static DensityUniforms withoutPhase(Uniforms uniforms) {
        return of(uniforms, null);
    }

    private static DensityUniforms of(Uniforms uniforms, Uniforms.Vector4 phase) {
        uniforms.sampler("cloudDensity", TextureUnit.CLOUD_DENSITY);
        return new DensityUniforms(BoxUniforms.of(uniforms, MOST_BOXES), uniforms.vector4("medium"), phase);
    }
}
