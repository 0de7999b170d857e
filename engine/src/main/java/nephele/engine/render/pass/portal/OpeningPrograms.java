package nephele.engine.render.pass.portal;

import java.util.Map;
import java.util.function.Function;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.FrameUniforms;

/** Programs that place openings alike, to the last bit of their depth. */
final class OpeningPrograms {
    private static final String FOLDER = "/nephele/engine/render/pass/portal/";

    private OpeningPrograms() {}

    /** Depth and stencil only. */
    static GlProgram<Object> nothing(LoadContext context) {
        return program(context, "nothing.frag", uniforms -> uniforms);
    }

    /** One colour. */
    static GlProgram<Uniforms.Vector4> colour(LoadContext context) {
        return program(context, "colour.frag", uniforms -> uniforms.vector4("colour"));
    }

    /** A picture, looked up. */
    static GlProgram<Object> picture(LoadContext context) {
        return program(context, "picture.frag", uniforms -> {
            uniforms.sampler("shown", TextureUnit.COLOURS);
            return uniforms;
        });
    }

    /** The fog between the eye and openings, times what they keep back. */
    static GlProgram<Uniforms.Vector3> fog(LoadContext context) {
        return program(context, "mirror-fog.frag", uniforms -> {
            uniforms.block("Frame", FrameUniforms.BINDING);
            return uniforms.vector3("keptBack");
        });
    }

    private static <U> GlProgram<U> program(LoadContext context, String fragment, Function<Uniforms, U> uniforms) {
        Map<String, String> defines = Defines.of(context).values();
        return new GlProgram<>(
                context.gl(),
                ShaderSource.load(FOLDER + "opening.vert", defines),
                ShaderSource.load(FOLDER + fragment, defines),
                uniforms);
    }
}
