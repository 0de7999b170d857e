package nephele.engine.render.pass.portal;

import java.util.Map;
import java.util.function.Function;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.Uniforms;

/** Programs that place openings at exactly the same depth. */
final class OpeningPrograms {
    private static final String FOLDER = "/nephele/engine/render/pass/portal/";

    private OpeningPrograms() {}

    /** Returns a program that writes only depth and stencil. */
    static GlProgram<Object> nothing(LoadContext context) {
        return program(context, "nothing.frag", uniforms -> uniforms);
    }

    /** Returns a program of one colour. */
    static GlProgram<Uniforms.Vector4> colour(LoadContext context) {
        return program(context, "colour.frag", uniforms -> uniforms.vector4("colour"));
    }

    /** Returns a program that looks up a picture. */
    static GlProgram<Object> picture(LoadContext context) {
        return program(context, "picture.frag", uniforms -> uniforms);
    }

    /** Returns a program for the fog between the eye and openings, times the part of light that they absorb. */
    static GlProgram<Uniforms.Vector3> fog(LoadContext context) {
        return program(context, "mirror-fog.frag", uniforms -> uniforms.vector3("keptBack"));
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
