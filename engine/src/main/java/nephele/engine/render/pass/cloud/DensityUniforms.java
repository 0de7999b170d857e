package nephele.engine.render.pass.cloud;

import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;

/** The uniforms with which a program finds the density of a cloud in its cells. */
public record DensityUniforms(BoxUniforms boxes, Uniforms.Vector4 medium, Uniforms.Vector4 phase) {
    /** Boxes that a cloud has at most; {@code MOST_BOXES} in shaders. */
    public static final int MOST_BOXES = 6;

    /** Finds the uniforms of a program and assigns its sampler. */
    public static DensityUniforms of(Uniforms uniforms) {
        uniforms.sampler("cloudDensity", TextureUnit.CLOUD_DENSITY);
        return new DensityUniforms(
                BoxUniforms.of(uniforms, MOST_BOXES), uniforms.vector4("medium"), uniforms.vector4("phase"));
    }
}
