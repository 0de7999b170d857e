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
        DensityUniforms density,
        Uniforms.Vector3 cloudSun,
        Uniforms.Vector4 diffuseAxis,
        Uniforms.Vector3 irradiance,
        Uniforms.Vector3 skyAbove,
        Uniforms.Vector3 skyBelow) {
    /** Finds the uniforms of a program and assigns its samplers. */
    public static CellUniforms of(Uniforms uniforms, CloudScattering scattering) {
        boolean isTwoStream = scattering == CloudScattering.TWO_STREAM;
        uniforms.sampler("cloudLight", TextureUnit.CLOUD_LIGHT);
        uniforms.sampler("cloudLightToCome", TextureUnit.CLOUD_LIGHT_TO_COME);
        if (isTwoStream) {
            uniforms.sampler("smallAngles", TextureUnit.SMALL_ANGLES);
        }
        return new CellUniforms(
                DensityUniforms.of(uniforms),
                uniforms.vector3("cloudSun"),
                isTwoStream ? uniforms.vector4("diffuseAxis") : null,
                uniforms.vector3("irradiance"),
                uniforms.vector3("skyAbove"),
                uniforms.vector3("skyBelow"));
    }
}
