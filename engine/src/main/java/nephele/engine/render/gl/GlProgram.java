package nephele.engine.render.gl;

import java.util.Map;
import java.util.function.Function;
import nephele.engine.render.gl.shader.LinkedPrograms;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.Uniforms;

/**
 * A linked program with the uniforms of one user. Equal sources are linked once in a context and shared, so a program
 * holds no data of a level: every draw sets all uniforms first, except samplers and blocks, which are bound to fixed
 * places by name.
 *
 * @param <U> its uniforms, a record made from {@link Uniforms}
 */
public final class GlProgram<U> {
    private final GlContext gl;
    private final int id;
    private final U uniforms;

    /**
     * Links the program or takes the linked one.
     *
     * @throws nephele.engine.render.gl.shader.GlException with file and line if the sources do not compile, or with the
     * name of a missing uniform
     */
    public GlProgram(GlContext gl, ShaderSource vertex, ShaderSource fragment, Function<Uniforms, U> uniforms) {
        this.gl = gl;
        id = gl.programs().linked(vertex, fragment);
        this.uniforms = uniforms.apply(new Uniforms(id, LinkedPrograms.name(vertex, fragment)));
    }

    /**
     * Links the program or takes the linked one, with a record of its uniforms as {@link Uniforms} describes.
     *
     * @param vertex path of the resource; {@code fragment} likewise
     */
    public static <U extends Record> GlProgram<U> of(
            GlContext gl, String vertex, String fragment, Map<String, String> defines, Class<U> uniforms) {
        return of(gl, ShaderSource.load(vertex, defines), ShaderSource.load(fragment, defines), uniforms);
    }

    /** Does the same for two sources. */
    public static <U extends Record> GlProgram<U> of(
            GlContext gl, ShaderSource vertex, ShaderSource fragment, Class<U> uniforms) {
        return new GlProgram<>(gl, vertex, fragment, found -> {
            found.requireUnits();
            return found.record(uniforms);
        });
    }

    /** Links the program or takes the linked one, without uniforms but samplers and blocks. */
    public static GlProgram<Uniforms> of(GlContext gl, String vertex, String fragment, Map<String, String> defines) {
        return of(gl, vertex, fragment, defines, found -> found);
    }

    /** Links the program or takes the linked one, with what a function makes of its uniforms. */
    public static <U> GlProgram<U> of(
            GlContext gl, String vertex, String fragment, Map<String, String> defines, Function<Uniforms, U> uniforms) {
        return new GlProgram<>(gl, ShaderSource.load(vertex, defines), ShaderSource.load(fragment, defines), uniforms);
    }

    public U uniforms() {
        return uniforms;
    }

    /** Makes this the current program. */
    public void use() {
        gl.bindings().program(id);
    }
}
