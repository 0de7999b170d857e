package nephele.architecture;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * A source file of the checkout.
 *
 * @param path relative to the repository, with slashes
 */
record SourceFile(String path, String text) {
    private static final List<String> ROOTS = List.of(
            "engine/src", "host/src", "scenes/src", "lab/src", "editor/src", "app/src", "workshop/src", "src/test");

    /** Returns every Java file and shader of the checkout. */
    static List<SourceFile> all() throws IOException {
        List<SourceFile> files = new ArrayList<>();
        for (String root : ROOTS) {
            try (Stream<Path> paths = Files.walk(Path.of(root))) {
                for (Path path : paths.filter(p -> p.toString().matches(".*\\.(java|glsl|vert|frag|geom)"))
                        .sorted()
                        .toList()) {
                    files.add(new SourceFile(path.toString().replace('\\', '/'), Files.readString(path)));
                }
            }
        }
        return files;
    }

    boolean isTest() {
        return path.startsWith("src/test/");
    }

    String simpleName() {
        String file = path.substring(path.lastIndexOf('/') + 1);
        return file.substring(0, file.lastIndexOf('.'));
    }

    /** Returns each match as {@code path:line: text}. */
    List<String> matches(Pattern pattern) {
        List<String> found = new ArrayList<>();
        Matcher matcher = pattern.matcher(text);
        while (matcher.find()) {
            long line = 1
                    + text.substring(0, matcher.start())
                            .chars()
                            .filter(c -> c == '\n')
                            .count();
            found.add(path + ":" + line + ": " + matcher.group().strip());
        }
        return found;
    }
}
