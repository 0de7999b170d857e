package nephele.lab.trade;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/** Reads the page's style sheet and script, which are resources beside this class. */
final class PageFile {
    private PageFile() {}

    static String read(String name) {
        try (var stream = PageFile.class.getResourceAsStream(name)) {
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
    }
}
