package nephele.engine.render.gl.shader;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The assembled text of a {@link ShaderSource}, with the origin of each line. */
final class AssembledShader {
    private static final String INCLUDE_FOLDER = "/nephele/engine/render/include/";
    private static final Pattern INCLUDE = Pattern.compile("\\s*#include\\s+\"([\\w./-]+)\"\\s*");
    private static final Pattern PLACE = Pattern.compile("(?m)^(?:ERROR: )?(\\d+)[:(](\\d+)\\)?");

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
                text.append(lines[i]).append('\n');
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
