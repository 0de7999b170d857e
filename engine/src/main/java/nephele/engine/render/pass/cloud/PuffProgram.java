package nephele.engine.render.pass.cloud;

import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.Quality.CloudScattering;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.Uniforms;

/** A program that draws the balls of a cloud as quads, with its numbers. */
public final class PuffProgram {
    private final GlProgram<Places> program;

    private record Places(PixelUniforms pixels, CellUniforms cells, Uniforms.Scalar margin) {}

    /**
     * @param shaders path of both shaders without the ending
     * @param choices further definitions
     */
    public PuffProgram(CloudContext context, CloudPixels pixels, String shaders, Defines choices) {
        var defines = choices.with("QUADS")
                .with("MOST_BOXES", CellUniforms.MOST_BOXES)
                .values();
        program = new GlProgram<>(
                context.load().gl(),
                ShaderSource.load(shaders + ".vert", defines),
                ShaderSource.load(shaders + ".frag", defines),
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
