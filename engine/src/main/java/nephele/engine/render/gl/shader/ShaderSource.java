package nephele.engine.render.gl.shader;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.function.UnaryOperator;

/**
 * The parts of a shader's GLSL: a file, its includes and defines. A value; files are read when it is compiled.
 *
 * <p>{@code #include "NAME"} inserts that file of {@code nephele/engine/render/include}, once; a name that begins with
 * a slash is the path of a resource of another module.
 *
 * @param read returns the text of a file by its path
 */
public record ShaderSource(String path, Map<String, String> defines, UnaryOperator<String> read) {
    private static final UnaryOperator<String> RESOURCES = ShaderSource::resource;

    public ShaderSource {
        defines = Map.copyOf(defines);
    }

    /**
     * Returns the source of a resource.
     *
     * @param resource absolute path, such as {@code /nephele/engine/render/pass/solid/solid.vert}
     */
    public static ShaderSource load(String resource, Map<String, String> defines) {
        return new ShaderSource(resource, defines, RESOURCES);
    }

    private static String resource(String path) {
        try (InputStream in = ShaderSource.class.getResourceAsStream(path)) {
            if (in == null) {
                throw new GlException("no shader file " + path);
            }
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new GlException("cannot read shader file " + path + ": " + e.getMessage());
        }
    }

    String name() {
        return path.substring(path.lastIndexOf('/') + 1);
    }
}
