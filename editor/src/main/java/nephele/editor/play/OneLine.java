package nephele.editor.play;

import java.nio.charset.StandardCharsets;

/** A JSON text as a single line: its line feeds are all between tokens. */
final class OneLine {
    private OneLine() {}

    static String of(String json) {
        return json.replaceAll("\\s*\\n\\s*", " ").strip();
    }

    static byte[] utf8(String line) {
        return line.getBytes(StandardCharsets.UTF_8);
    }
}
