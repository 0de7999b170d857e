package nephele.lab.trade;

/** An HTML page in the style of the report, which needs no other file and no network. */
public final class HtmlDocument {
    private HtmlDocument() {}

    /** @param body HTML of all that is shown */
    public static String of(String title, String body) {
        return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                + "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" + text(title)
                + "</title>\n<style>\n" + PageFile.read("page.css") + "</style>\n</head>\n<body>\n" + body
                + "</body>\n</html>\n";
    }

    /** Returns plain text as HTML. */
    public static String text(String plain) {
        return Svg.escaped(plain);
    }
}
