package nephele.engine.render.gl.shader;

import java.lang.reflect.Field;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collector;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import nephele.engine.math.Vec3;

/**
 * The assembled text of a {@link ShaderSource}, with the origin of each line. In place of {@code
 * java(scene.impostor.ImpostorAtlas.SIDE)} stands the value of that constant of a class of the engine: a number, a vector
 * for a {@link Vec3} or a row of an array, the ordinal of a constant of an enum.
 */
final class AssembledShader {
    private static final String INCLUDE_FOLDER = "/nephele/engine/render/include/";
    private static final Pattern INCLUDE = Pattern.compile("\\s*#include\\s+\"([\\w./-]+)\"\\s*");
    private static final Pattern CONSTANT =
            Pattern.compile("\\bjava\\(([a-z.]+)\\.([A-Z]\\w*(?:\\.[A-Z]\\w*)*)\\.([A-Z]\\w*)\\)");
    private static final Pattern PLACE = Pattern.compile("(?m)^(?:ERROR: )?(\\d+)[:(](\\d+)\\)?");

    private static final Collector<CharSequence, ?, String> LIST = Collectors.joining(", ", "(", ")");

    private final ShaderSource source;
    private final List<String> files = new ArrayList<>();
    private final Set<String> open = new HashSet<>();
    private final StringBuilder text = new StringBuilder();

    /**
     * Assembles the text.
     *
     * @throws GlException that names a file that is missing or includes itself
     */
    AssembledShader(ShaderSource source) {
        this.source = source;
        text.append("#version 410 core\n");
        new TreeMap<>(source.defines()).forEach((name, value) -> text.append("#define ")
                .append(name)
                .append(' ')
                .append(value)
                .append('\n'));
        append(source.path());
    }

    private void append(String path) {
        if (!files.contains(path)) {
            files.add(path);
        }
        int index = files.indexOf(path);
        String[] lines = source.read().apply(path).split("\n", -1);
        text.append("#line 1 ").append(index).append('\n');
        for (int i = 0; i < lines.length; i++) {
            Matcher include = INCLUDE.matcher(lines[i]);
            if (include.matches()) {
                appendOnce(include.group(1), path);
                text.append("#line ").append(i + 2).append(' ').append(index).append('\n');
            } else {
                text.append(withConstants(lines[i], path)).append('\n');
            }
        }
    }

    /**
     * Appends an include behind a guard: only the compiler can decide which of several inclusions counts, because the
     * first one may be in a branch that is not taken.
     */
    private void appendOnce(String name, String includedFrom) {
        boolean isAbsolute = name.startsWith("/");
        String path = isAbsolute ? name : INCLUDE_FOLDER + name;
        if (open.contains(path)) {
            throw new GlException(includedFrom + " includes " + path + ", which includes it in turn");
        }
        String guard = "INCLUDED_" + name.substring(isAbsolute ? 1 : 0).replaceAll("\\W", "_");
        text.append("#ifndef ").append(guard).append("\n#define ").append(guard).append('\n');
        open.add(path);
        append(path);
        open.remove(path);
        text.append("\n#endif\n");
    }

    private static String withConstants(String line, String path) {
        return line.contains("java(")
                ? CONSTANT.matcher(line)
                        .replaceAll(found -> constant(found.group(1), found.group(2), found.group(3), path))
                : line;
    }

    private static String constant(String folder, String types, String name, String path) {
        String type = "nephele.engine." + folder + "." + types.replace('.', '$');
        try {
            Field field = Class.forName(type).getDeclaredField(name);
            field.setAccessible(true);
            return value(field.get(null));
        } catch (ReflectiveOperationException | NullPointerException e) {
            throw new GlException(path + " needs a constant " + name + " of " + type + ", which does not exist");
        }
    }

    private static String value(Object value) {
        if (value instanceof Vec3 v) {
            return "vec3(" + value(v.x()) + ", " + value(v.y()) + ", " + value(v.z()) + ")";
        }
        if (value instanceof Enum<?> word) {
            return Integer.toString(word.ordinal());
        }
        if (value instanceof double[] row) {
            return "vec" + row.length
                    + DoubleStream.of(row).mapToObj(AssembledShader::value).collect(LIST);
        }
        if (value instanceof double[][] rows) {
            return "vec" + rows[0].length + "[]"
                    + Stream.of(rows).map(AssembledShader::value).collect(LIST);
        }
        return value instanceof Integer ? value.toString() : Float.toString(((Number) value).floatValue());
    }

    String text() {
        return text.toString();
    }

    /** Returns a compiler's log with {@code file:line} in place of its string and line numbers. */
    String withFileNames(String log) {
        return PLACE.matcher(log).replaceAll(place -> {
            int file = Integer.parseInt(place.group(1));
            String path = file < files.size() ? files.get(file) : "?";
            return Matcher.quoteReplacement(path.substring(path.lastIndexOf('/') + 1) + ":" + place.group(2));
        });
    }
}
