package nephele.lab.trade;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/** An HTML page in the style of the report, which needs no other file and no network. */
public final class HtmlDocument {
    private HtmlDocument() {}

    /** @param body HTML of all that is shown */
    public static String of(String title, String body) {
        return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                + "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" + text(title)
                + "</title>\n<style>\n" + resource("page.css") + "</style>\n</head>\n<body>\n" + body
                + "</body>\n</html>\n";
    }

    /** Returns plain text as HTML or SVG. */
    public static String text(String plain) {
        return plain.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    /** Reads the page's style sheet and script, which are resources beside this class. */
    static String resource(String name) {
        try (var stream = HtmlDocument.class.getResourceAsStream(name)) {
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
    }
}
