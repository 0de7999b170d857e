package nephele.engine.render.pass.cloud.volume;

import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.FrameUniforms;

/** {@code volume.frag} with the places of its numbers. */
final class MarchProgram {
    private static final String FOLDER = "/nephele/engine/render/pass/cloud/volume/";

    private final GlProgram<Places> program;

    /** The numbers of a cloud and of the light around it. */
    record Places(
            Uniforms.Vector4 cells,
            Uniforms.Vector3 cloudBase,
            Uniforms.Vector3 cloudHalf,
            Uniforms.Vector4 medium,
            Uniforms.Vector3 phase,
            Uniforms.Vector3 cloudSun,
            Uniforms.Vector2 stepping,
            Uniforms.Vector3 irradiance,
            Uniforms.Vector3 skyAbove,
            Uniforms.Vector3 skyBelow) {
        static Places of(Uniforms uniforms) {
            return new Places(
                    uniforms.vector4("cells"),
                    uniforms.vector3("cloudBase"),
                    uniforms.vector3("cloudHalf"),
                    uniforms.vector4("medium"),
                    uniforms.vector3("phase"),
                    uniforms.vector3("cloudSun"),
                    uniforms.vector2("stepping"),
                    uniforms.vector3("irradiance"),
                    uniforms.vector3("skyAbove"),
                    uniforms.vector3("skyBelow"));
        }
    }

    MarchProgram(LoadContext context, Defines choices) {
        var defines = choices.values();
        program = new GlProgram<>(
                context.gl(),
                ShaderSource.load(FOLDER + "volume.vert", defines),
                ShaderSource.load(FOLDER + "volume.frag", defines),
                uniforms -> {
                    uniforms.block("Frame", FrameUniforms.BINDING);
                    uniforms.sampler("viewDepth", TextureUnit.VIEW_DEPTH);
                    uniforms.sampler("cloudDensity", TextureUnit.CLOUD_DENSITY);
                    uniforms.sampler("cloudLight", TextureUnit.CLOUD_LIGHT);
                    uniforms.sampler("smallAngles", TextureUnit.SMALL_ANGLES);
                    return Places.of(uniforms);
                });
    }

    void use() {
        program.use();
    }

    Places places() {
        return program.uniforms();
    }
}
