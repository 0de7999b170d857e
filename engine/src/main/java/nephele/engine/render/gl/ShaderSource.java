package nephele.engine.render.gl;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
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
    private final Set<String> open = new HashSet<>();
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
        if (!files.contains(path)) {
            files.add(path);
        }
        int index = files.indexOf(path);
        String[] lines = read.apply(path).split("\n", -1);
        text.append("#line 1 ").append(index).append('\n');
        for (int i = 0; i < lines.length; i++) {
            Matcher include = INCLUDE.matcher(lines[i]);
            if (include.matches()) {
                appendOnce(INCLUDE_FOLDER + include.group(1), path);
                text.append("#line ").append(i + 2).append(' ').append(index).append('\n');
            } else {
                text.append(lines[i]).append('\n');
            }
        }
    }

    /** The compiler decides which of several inclusions counts: the first one may lie in a branch that is not taken. */
    private void appendOnce(String path, String includedFrom) {
        if (open.contains(path)) {
            throw new GlException(includedFrom + " includes " + path + ", which includes it in turn");
        }
        String guard = "INCLUDED_" + path.substring(INCLUDE_FOLDER.length()).replaceAll("\\W", "_");
        text.append("#ifndef ").append(guard).append("\n#define ").append(guard).append('\n');
        open.add(path);
        append(path);
        open.remove(path);
        text.append("\n#endif\n");
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
