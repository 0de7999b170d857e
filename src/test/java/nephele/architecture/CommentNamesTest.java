package nephele.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Classes, members and shaders that comments of Java and GLSL name exist. */
@Execution(ExecutionMode.CONCURRENT)
class CommentNamesTest {
    private static final Pattern COMMENT = Pattern.compile("(?s)/\\*.*?\\*/|//[^\n]*");
    private static final Pattern MARKED = Pattern.compile("\\{@(?:link|linkplain|code)\\s+([^}\\s]+)");
    private static final Pattern TYPE =
            Pattern.compile("((?:[a-z]\\w*\\.)*)([A-Z]\\w*[a-z]\\w*)((?:[.#]\\w+)*)(?:\\(.*)?");
    private static final Pattern IN_A_SHADER = Pattern.compile("\\b(?:[a-z]\\w*\\.)+[A-Z]\\w*(?:[.#]\\w+)*");
    private static final Pattern SHADER = Pattern.compile("[\\w-]+\\.(?:glsl|frag|vert|geom)");

    /** Names of keys, and classes of libraries that their comment explains without importing them. */
    private static final Set<String> OTHERS =
            Set.of("Delete", "PageUp", "JsonReader", "Vector3d", "CancellationException", "KeyEvent", "BufferedImage");

    private final Map<String, List<String>> textsOfType = new HashMap<>();
    private final Set<String> shaders = new TreeSet<>();

    @Test
    void namesInCommentsExist() throws IOException {
        List<SourceFile> sources = SourceFile.all();
        for (SourceFile source : sources) {
            Matcher declared = Pattern.compile("\\b(?:class|interface|enum|record)\\s+([A-Z]\\w*)")
                    .matcher(source.text());
            while (source.path().endsWith(".java") && declared.find()) {
                textsOfType
                        .computeIfAbsent(declared.group(1), type -> new ArrayList<>())
                        .add(source.text());
            }
            shaders.add(Path.of(source.path()).getFileName().toString());
        }
        Set<String> unknown = new TreeSet<>();
        for (SourceFile source : sources) {
            for (String name : names(source)) {
                if (!exists(name)) {
                    unknown.add(source.path() + ": " + name);
                }
            }
        }
        assertEquals(Set.of(), unknown);
    }

    private static List<String> names(SourceFile source) {
        boolean isJava = source.path().endsWith(".java");
        Pattern name = isJava ? MARKED : IN_A_SHADER;
        return COMMENT.matcher(source.text())
                .results()
                .map(comment -> comment.group().replaceAll("\n\\s*\\*", " "))
                .flatMap(comment -> name.matcher(comment).results())
                .map(found -> found.group(isJava ? 1 : 0))
                .toList();
    }

    private boolean exists(String name) {
        if (SHADER.matcher(name).matches()) {
            return shaders.contains(name);
        }
        Matcher type = TYPE.matcher(name);
        if (!type.matches() || OTHERS.contains(type.group(2)) || type.group(1).matches("(java|javax|org)\\..*")) {
            return true;
        }
        List<String> texts = textsOfType.get(type.group(2));
        if (texts == null) {
            return isOfJava(type.group(2));
        }
        List<String> members = Stream.of(type.group(3).split("[.#]"))
                .filter(member -> !member.isEmpty())
                .toList();
        return members.isEmpty()
                || texts.stream().anyMatch(text -> Pattern.compile("\\b" + members.get(members.size() - 1) + "\\b")
                        .matcher(text)
                        .find());
    }

    private static boolean isOfJava(String type) {
        try {
            Class.forName("java.lang." + type);
            return true;
        } catch (ClassNotFoundException unknown) {
            return false;
        }
    }
}
