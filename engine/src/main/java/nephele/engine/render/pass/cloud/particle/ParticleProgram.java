package nephele.engine.render.pass.cloud.particle;

import nephele.engine.render.frame.Quality.CloudScattering;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.pass.cloud.CellUniforms;
import nephele.engine.render.pass.cloud.CloudContext;
import nephele.engine.render.pass.cloud.CloudPixels;
import nephele.engine.render.pass.cloud.PixelUniforms;

/** {@code particle.frag} with its numbers. */
final class ParticleProgram {
    private static final String FOLDER = "/nephele/engine/render/pass/cloud/particle/";

    private final GlProgram<Places> program;

    private record Places(PixelUniforms pixels, CellUniforms cells, Uniforms.Scalar margin) {}

    ParticleProgram(CloudContext context, CloudPixels pixels) {
        var defines = PixelUniforms.defines(context, pixels)
                .with("QUADS")
                .with("MOST_BOXES", CellUniforms.MOST_BOXES)
                .values();
        program = new GlProgram<>(
                context.load().gl(),
                ShaderSource.load(FOLDER + "particle.vert", defines),
                ShaderSource.load(FOLDER + "particle.frag", defines),
                uniforms -> new Places(
                        PixelUniforms.of(uniforms, context, pixels),
                        CellUniforms.of(uniforms, CloudScattering.TWO_STREAM),
                        uniforms.scalar("margin")));
    }

    void use(double margin) {
        program.use();
        program.uniforms().margin().set((float) margin);
    }

    PixelUniforms pixels() {
        return program.uniforms().pixels();
    }

    CellUniforms cells() {
        return program.uniforms().cells();
    }
}
