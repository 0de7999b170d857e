package nephele.engine.level;

import java.nio.charset.StandardCharsets;
import java.util.function.Supplier;

/**
 * One kind of bad input.
 *
 * @param path the path that the message must name
 * @param words text that it must contain
 */
public record BadLevel(String name, String path, String words, Supplier<byte[]> content) {
    /** Returns a whole file. */
    static BadLevel file(String name, String path, String words, String text) {
        return new BadLevel(name, path, words, () -> text.getBytes(StandardCharsets.UTF_8));
    }

    /** Returns a level with these sections. */
    static BadLevel level(String path, String words, String sections) {
        return file(path + " " + words, path, words, wrap(sections));
    }

    public static String wrap(String sections) {
        return "{\"format\": \"nephele-level\", \"version\": 1, " + sections + "}";
    }

    /** Returns copies of {@code element}, separated by commas. */
    static String repeated(String element, int count) {
        StringBuilder text = new StringBuilder(count * (element.length() + 1)).append(element);
        for (int i = 1; i < count; i++) {
            text.append(',').append(element);
        }
        return text.toString();
    }

    @Override
    public String toString() {
        return name;
    }
}
