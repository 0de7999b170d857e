package nephele.engine.render.gl;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * GLSL text put together from a resource, its includes and defines; it knows which line came from which file.
 *
 * <p>{@code #include "name.glsl"} takes {@code nephele/engine/render/include/name.glsl}, each file once.
 */
public final class ShaderSource {
    private static final String INCLUDE_FOLDER = "/nephele/engine/render/include/";
    private static final Pattern INCLUDE = Pattern.compile("\\s*#include\\s+\"([\\w./-]+)\"\\s*");
    private static final Pattern PLACE = Pattern.compile("(?m)^(?:ERROR: )?(\\d+)[:(](\\d+)\\)?");

    private final List<String> files = new ArrayList<>();
    private final StringBuilder text = new StringBuilder();
    private final UnaryOperator<String> read;

    private ShaderSource(UnaryOperator<String> read) {
        this.read = read;
    }

    /** @param resource absolute path of a resource, such as {@code /nephele/engine/render/pass/solid/solid.vert} */
    public static ShaderSource load(String resource, Map<String, String> defines) {
        return assemble(resource, defines, ShaderSource::resource);
    }

    /** As {@link #load}, reading files through {@code read}. */
    static ShaderSource assemble(String path, Map<String, String> defines, UnaryOperator<String> read) {
        ShaderSource source = new ShaderSource(read);
        source.text.append("#version 410 core\n");
        new TreeMap<>(defines).forEach((name, value) -> source.text
                .append("#define ")
                .append(name)
                .append(' ')
                .append(value)
                .append('\n'));
        source.append(path);
        return source;
    }

    private void append(String path) {
        int index = files.size();
        files.add(path);
        String[] lines = read.apply(path).split("\n", -1);
        text.append("#line 1 ").append(index).append('\n');
        for (int i = 0; i < lines.length; i++) {
            Matcher include = INCLUDE.matcher(lines[i]);
            if (!include.matches()) {
                text.append(lines[i]).append('\n');
                continue;
            }
            String included = INCLUDE_FOLDER + include.group(1);
            if (!files.contains(included)) {
                append(included);
            }
            text.append("#line ").append(i + 2).append(' ').append(index).append('\n');
        }
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

    String text() {
        return text.toString();
    }

    String name() {
        return files.get(0).substring(files.get(0).lastIndexOf('/') + 1);
    }

    /** A compiler's log with {@code file:line} in place of its string and line numbers. */
    String withFileNames(String log) {
        return PLACE.matcher(log).replaceAll(place -> {
            int file = Integer.parseInt(place.group(1));
            String path = file < files.size() ? files.get(file) : "?";
            return Matcher.quoteReplacement(path.substring(path.lastIndexOf('/') + 1) + ":" + place.group(2));
        });
    }
}
