package nephele.engine.render.pass.cloud;

import nephele.engine.render.frame.Quality.CloudScattering;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;

/**
 * The uniforms of {@code cloud-light.glsl}, and of the light around a cloud.
 *
 * @param diffuseAxis {@code null} for octaves, which have none, and for balls whose sunlight comes along the beam alone
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
        if (isTwoStream) {
            uniforms.sampler("smallAngles", TextureUnit.SMALL_ANGLES);
        }
        return of(uniforms, DensityUniforms.of(uniforms), isTwoStream ? uniforms.vector4("diffuseAxis") : null);
    }

    /** Does the same for balls whose sunlight comes along the beam alone. */
    static CellUniforms ofBeam(Uniforms uniforms) {
        return of(uniforms, DensityUniforms.withoutPhase(uniforms), null);
    }

    private static CellUniforms of(Uniforms uniforms, DensityUniforms density, Uniforms.Vector4 diffuseAxis) {
        uniforms.sampler("cloudLight", TextureUnit.CLOUD_LIGHT);
        uniforms.sampler("cloudLightToCome", TextureUnit.CLOUD_LIGHT_TO_COME);
        return new CellUniforms(
                density,
                uniforms.vector3("cloudSun"),
                diffuseAxis,
                uniforms.vector3("irradiance"),
                uniforms.vector3("skyAbove"),
                uniforms.vector3("skyBelow"));
    }
}
