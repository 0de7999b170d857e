package nephele.engine.render.gl;

import java.util.function.Function;
import nephele.engine.render.gl.shader.LinkedPrograms;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.Uniforms;

/**
 * A linked program as one user of it sees it. Equal sources are linked once for a context and shared, so a program holds
 * nothing of a level: whoever draws with it sets every uniform before, but for samplers and blocks, which are tied to
 * their places by name.
 *
 * @param <U> its uniforms, a record made from {@link nephele.engine.render.gl.shader.Uniforms}
 */
public final class GlProgram<U> {
    private final GlContext gl;
    private final int id;
    private final U uniforms;

    /** @throws nephele.engine.render.gl.shader.GlException with file and line where the sources do not compile, or naming the missing uniform */
    public GlProgram(GlContext gl, ShaderSource vertex, ShaderSource fragment, Function<Uniforms, U> uniforms) {
        this.gl = gl;
        id = gl.programs().linked(vertex, fragment);
        this.uniforms = uniforms.apply(new Uniforms(id, LinkedPrograms.name(vertex, fragment)));
    }

    public U uniforms() {
        return uniforms;
    }

    public void use() {
        gl.bindings().program(id);
    }
}
