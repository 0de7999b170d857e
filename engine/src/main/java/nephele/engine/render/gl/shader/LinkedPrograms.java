package nephele.engine.render.gl.shader;

import static org.lwjgl.opengl.GL41C.*;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The programs of a context, keyed by their sources. They live as long as the context, so an edit or the next level
 * compiles nothing again.
 */
public final class LinkedPrograms {
    /** The programs by vertex and fragment shader. */
    private final Map<List<ShaderSource>, Integer> linked = new HashMap<>();

    public static String name(ShaderSource vertex, ShaderSource fragment) {
        return vertex.name() + "+" + fragment.name();
    }

    /**
     * Returns the program of these sources, which is linked on first use.
     *
     * @throws GlException with file and line if the sources do not compile
     */
    public int linked(ShaderSource vertex, ShaderSource fragment) {
        List<ShaderSource> sources = List.of(vertex, fragment);
        Integer known = linked.get(sources);
        if (known == null) {
            known = link(vertex, fragment);
            linked.put(sources, known);
        }
        return known;
    }

    private static int link(ShaderSource vertex, ShaderSource fragment) {
        int program = glCreateProgram();
        int v = 0;
        int f = 0;
        try {
            v = compile(GL_VERTEX_SHADER, vertex);
            f = compile(GL_FRAGMENT_SHADER, fragment);
            glAttachShader(program, v);
            glAttachShader(program, f);
            glLinkProgram(program);
            if (glGetProgrami(program, GL_LINK_STATUS) == GL_FALSE) {
                throw new GlException(name(vertex, fragment) + " does not link:\n" + glGetProgramInfoLog(program));
            }
            new Uniforms(program, name(vertex, fragment)).bindByName();
            return program;
        } catch (GlException e) {
            glDeleteProgram(program);
            throw e;
        } finally {
            glDeleteShader(v);
            glDeleteShader(f);
        }
    }

    private static int compile(int stage, ShaderSource source) {
        AssembledShader assembled = new AssembledShader(source);
        int shader = glCreateShader(stage);
        glShaderSource(shader, assembled.text());
        glCompileShader(shader);
        if (glGetShaderi(shader, GL_COMPILE_STATUS) == GL_FALSE) {
            String log = assembled.withFileNames(glGetShaderInfoLog(shader));
            glDeleteShader(shader);
            throw new GlException(source.name() + " does not compile:\n" + log);
        }
        return shader;
    }

    public void close() {
        linked.values().forEach(program -> glDeleteProgram(program));
        linked.clear();
    }
}
