package nephele.engine.render.gl.shader;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.function.UnaryOperator;

/**
 * What a shader's GLSL is put together from: a file, its includes and defines. A value; nothing is read before it is
 * compiled.
 *
 * <p>{@code #include "name.glsl"} takes {@code nephele/engine/render/include/name.glsl}, each file once.
 *
 * @param read the text of a file by its path
 */
public record ShaderSource(String path, Map<String, String> defines, UnaryOperator<String> read) {
    private static final UnaryOperator<String> RESOURCES = ShaderSource::resource;

    public ShaderSource {
        defines = Map.copyOf(defines);
    }

    /** @param resource absolute path of a resource, such as {@code /nephele/engine/render/pass/solid/solid.vert} */
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
