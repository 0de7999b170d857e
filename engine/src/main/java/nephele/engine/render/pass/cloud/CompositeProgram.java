package nephele.engine.render.pass.cloud;

import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.frame.FrameUniforms;
import nephele.engine.render.gl.shader.Uniforms;

/** {@code composite.frag}, which draws a layer of clouds over a view. */
final class CompositeProgram {
    private static final String FOLDER = "/nephele/engine/render/pass/cloud/";

    private final GlProgram<Places> program;

    /** @param ranges absent unless surfaces can be among the clouds */
    private record Places(@Uniforms.IfRead CloudRanges.Places ranges) {}

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
        program = GlProgram.of(context.gl(), FOLDER + "cloud.vert", FOLDER + "composite.frag", defines, Places.class);
    }

    void use() {
        program.use();
    }

    CloudRanges.Places ranges() {
        return program.uniforms().ranges;
    }
}
