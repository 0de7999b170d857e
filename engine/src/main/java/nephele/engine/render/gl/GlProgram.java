package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

import java.util.function.Function;

/**
 * A linked program.
 *
 * @param <U> its uniforms, a record made from {@link Uniforms} when the program is linked
 */
public final class GlProgram<U> implements AutoCloseable {
    private final GlContext gl;
    private final GlHandle handle;
    private final U uniforms;

    /** @throws GlException with file and line where the sources do not compile, or naming the missing uniform */
    public GlProgram(GlContext gl, ShaderSource vertex, ShaderSource fragment, Function<Uniforms, U> uniforms) {
        this.gl = gl;
        String name = vertex.name() + "+" + fragment.name();
        this.handle = new GlHandle(gl, GlKind.PROGRAM, name, glCreateProgram(), id -> glDeleteProgram(id));
        try {
            link(vertex, fragment);
            this.uniforms = uniforms.apply(new Uniforms(handle.id(), name));
        } catch (RuntimeException e) {
            handle.close();
            throw e;
        }
    }

    private void link(ShaderSource vertex, ShaderSource fragment) {
        int v = compile(GL_VERTEX_SHADER, vertex);
        int f = 0;
        try {
            f = compile(GL_FRAGMENT_SHADER, fragment);
            glAttachShader(handle.id(), v);
            glAttachShader(handle.id(), f);
            glLinkProgram(handle.id());
            if (glGetProgrami(handle.id(), GL_LINK_STATUS) == GL_FALSE) {
                throw new GlException(handle.name() + " does not link:\n" + glGetProgramInfoLog(handle.id()));
            }
        } finally {
            glDeleteShader(v);
            glDeleteShader(f);
        }
    }

    private static int compile(int stage, ShaderSource source) {
        int shader = glCreateShader(stage);
        glShaderSource(shader, source.text());
        glCompileShader(shader);
        if (glGetShaderi(shader, GL_COMPILE_STATUS) == GL_FALSE) {
            String log = source.withFileNames(glGetShaderInfoLog(shader));
            glDeleteShader(shader);
            throw new GlException(source.name() + " does not compile:\n" + log);
        }
        return shader;
    }

    public U uniforms() {
        return uniforms;
    }

    public void use() {
        gl.bindings().program(handle.id());
    }

    @Override
    public void close() {
        handle.close();
    }
}
