package nephele.engine.render.pass.cloud;

import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.Quality.CloudScattering;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.Uniforms;

/** A program that draws the balls of a cloud as quads, with its numbers. */
public final class PuffProgram {
    private final GlProgram<Places> program;

    private record Places(
            PixelUniforms pixels, CellUniforms cells, Uniforms.Vector4 stepping, Uniforms.Scalar margin) {}

    /**
     * @param shaders path of both shaders without the ending
     * @param choices further definitions
     */
    public PuffProgram(CloudContext context, CloudPixels pixels, String shaders, Defines choices) {
        var defines = choices.with("QUADS")
                .with("MOST_BOXES", DensityUniforms.MOST_BOXES)
                .values();
        program = new GlProgram<>(
                context.load().gl(),
                ShaderSource.load(shaders + ".vert", defines),
                ShaderSource.load(shaders + ".frag", defines),
                uniforms -> {
                    return new Places(
                            PixelUniforms.of(uniforms, context, pixels),
                            CellUniforms.of(uniforms, CloudScattering.TWO_STREAM),
                            uniforms.vector4("stepping"),
                            uniforms.scalar("margin"));
                });
    }

    /** Uses it for a cloud. */
    void use(CloudCanvas canvas, PlacedCloud placed, LitCloud lit) {
        program.use();
        Places places = program.uniforms();
        canvas.put(places.pixels, placed);
        lit.put(places.cells, canvas.view(), canvas.focus());
        places.stepping.set(1, 0.5f, (float) canvas.view().eyeY(), (float) lit.depthAround(canvas.view()));
        places.margin.set((float) canvas.margin());
    }
}
