package nephele.engine.render.pass.cloud;

import nephele.engine.render.frame.Quality.CloudScattering;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;

/**
 * The uniforms of {@code cloud-light.glsl}, and of the light around a cloud.
 *
 * @param diffuseAxis {@code null} for octaves, which have none
 */
public record CellUniforms(
        BoxUniforms boxes,
        Uniforms.Vector4 medium,
        Uniforms.Vector4 phase,
        Uniforms.Vector3 cloudSun,
        Uniforms.Vector4 diffuseAxis,
        Uniforms.Vector3 irradiance,
        Uniforms.Vector3 skyAbove,
        Uniforms.Vector3 skyBelow) {
    /** Boxes that a cloud has at most; {@code MOST_BOXES} in shaders. */
    public static final int MOST_BOXES = 6;

    /** Finds the uniforms of a program and assigns its samplers. */
    public static CellUniforms of(Uniforms uniforms, CloudScattering scattering) {
        boolean isTwoStream = scattering == CloudScattering.TWO_STREAM;
        uniforms.sampler("cloudDensity", TextureUnit.CLOUD_DENSITY);
        uniforms.sampler("cloudLight", TextureUnit.CLOUD_LIGHT);
        uniforms.sampler("cloudLightToCome", TextureUnit.CLOUD_LIGHT_TO_COME);
        if (isTwoStream) {
            uniforms.sampler("smallAngles", TextureUnit.SMALL_ANGLES);
        }
        return new CellUniforms(
                BoxUniforms.of(uniforms, MOST_BOXES),
                uniforms.vector4("medium"),
                uniforms.vector4("phase"),
                uniforms.vector3("cloudSun"),
                isTwoStream ? uniforms.vector4("diffuseAxis") : null,
                uniforms.vector3("irradiance"),
                uniforms.vector3("skyAbove"),
                uniforms.vector3("skyBelow"));
    }
}
