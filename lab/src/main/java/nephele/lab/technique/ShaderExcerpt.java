package nephele.lab.technique;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import nephele.lab.trade.HtmlDocument;

/**
 * A function of a shader with the comment before it.
 *
 * @param file path from the folder of the renderer's resources
 * @param lines of the whole file
 * @param first index of the first line of the function, its comment included
 * @param end index after its last line
 */
record ShaderExcerpt(String file, List<String> lines, int first, int end) {
    private static final String FOLDER = "/nephele/engine/render/";

    /** Finds a function; empty if there is no such file or no such function. */
    static Optional<ShaderExcerpt> of(String file, String function) {
        List<String> lines = lines(file);
        for (int i = 0; i < lines.size(); i++) {
            if (lines.get(i).matches("[A-Za-z].* " + function + "\\(.*")
                    && !lines.get(i).endsWith(";")) {
                int first = i;
                while (first > 0 && lines.get(first - 1).startsWith("//")) {
                    first--;
                }
                int last = i;
                while (last < lines.size() && !lines.get(last).equals("}")) {
                    last++;
                }
                return last == lines.size()
                        ? Optional.empty()
                        : Optional.of(new ShaderExcerpt(file, lines, first, last + 1));
            }
        }
        return Optional.empty();
    }

    private static List<String> lines(String file) {
        try (var stream = ShaderExcerpt.class.getResourceAsStream(FOLDER + file)) {
            return stream == null
                    ? List.of()
                    : new String(stream.readAllBytes(), StandardCharsets.UTF_8)
                            .lines()
                            .toList();
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
    }

    /** Returns the function with the numbers of its lines, and the whole file to be opened. */
    String html() {
        return "<p class=\"about\">Lines " + (first + 1) + " to " + end + " of <code>" + HtmlDocument.text(file)
                + "</code></p>\n" + numbered(first, end) + "<details><summary>the whole file, " + lines.size()
                + " lines</summary>" + numbered(0, lines.size()) + "</details>\n";
    }

    private String numbered(int from, int to) {
        var html = new StringBuilder("<pre>");
        for (int i = from; i < to; i++) {
            html.append(String.format(Locale.ROOT, "<i>%3d  </i>", i + 1))
                    .append(HtmlDocument.text(lines.get(i)))
                    .append('\n');
        }
        return html.append("</pre>\n").toString();
    }
}
