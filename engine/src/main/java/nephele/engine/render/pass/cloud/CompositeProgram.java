package nephele.engine.render.pass.cloud;

import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.frame.FrameUniforms;

/** {@code composite.frag}, which draws a layer of clouds over a view. */
final class CompositeProgram {
    private static final String FOLDER = "/nephele/engine/render/pass/cloud/";

    private final GlProgram<CloudRanges.Places> program;

    /**
     * @param mixed whether surfaces can be among the clouds
     * @param divisor pixels of the view along each side of one of the layer
     */
    CompositeProgram(LoadContext context, boolean mixed, int clouds, int divisor) {
        var defines = Defines.of(context)
                .withIf(mixed, "MIXED")
                .withIf(!mixed, "FARTHEST")
                .with("CLOUDS", clouds)
                .with("DIVISOR", (double) divisor)
                .values();
        program = new GlProgram<>(
                context.gl(),
                ShaderSource.load(FOLDER + "cloud.vert", defines),
                ShaderSource.load(FOLDER + "composite.frag", defines),
                uniforms -> {
                    if (mixed) {
                        uniforms.block("Frame", FrameUniforms.BINDING);
                        uniforms.sampler("viewDepth", TextureUnit.VIEW_DEPTH);
                    }
                    uniforms.sampler("clouds", TextureUnit.COLOURS);
                    return mixed ? CloudRanges.Places.of(uniforms, clouds) : null;
                });
    }

    void use() {
        program.use();
    }

    /** Returns {@code null} unless surfaces can be among the clouds. */
    CloudRanges.Places ranges() {
        return program.uniforms();
    }
}
