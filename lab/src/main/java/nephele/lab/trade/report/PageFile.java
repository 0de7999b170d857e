package nephele.lab.trade.report;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/** What a page is styled and moved by, from beside this class. */
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
