package nephele.engine.render.pass.cloud;

import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;

/** {@code join.frag}, which smooths a layer of clouds once, so that a pixel of the view needs one look at it. */
final class JoinProgram {
    private static final String FOLDER = "/nephele/engine/render/pass/cloud/";

    private final GlProgram<Uniforms> program;

    JoinProgram(LoadContext context) {
        var defines = Defines.of(context).values();
        program = new GlProgram<>(
                context.gl(),
                ShaderSource.load(FOLDER + "cloud.vert", defines),
                ShaderSource.load(FOLDER + "join.frag", defines),
                uniforms -> {
                    uniforms.sampler("clouds", TextureUnit.COLOURS);
                    return uniforms;
                });
    }

    void use() {
        program.use();
    }
}
