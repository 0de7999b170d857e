package nephele.lab.trade;

import java.util.Locale;

/** A writer of the few shapes that a plot needs. Colours come from classes, so that a page can be light or dark. */
final class Svg {
    private final StringBuilder text = new StringBuilder();

    static String escaped(String plain) {
        return plain.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    Svg line(String style, double x1, double y1, double x2, double y2) {
        return add("<line class=\"%s\" x1=\"%s\" y1=\"%s\" x2=\"%s\" y2=\"%s\"/>", style, n(x1), n(y1), n(x2), n(y2));
    }

    Svg path(String style, String d) {
        return add("<path class=\"%s\" d=\"%s\"/>", style, d);
    }

    /** @param title shown when the pointer is over the circle */
    Svg circle(String style, double x, double y, double radius, String title) {
        return add(
                "<circle class=\"%s\" cx=\"%s\" cy=\"%s\" r=\"%s\"><title>%s</title></circle>",
                style, n(x), n(y), n(radius), escaped(title));
    }

    /** @param anchor start, middle or end */
    Svg text(String style, double x, double y, String anchor, String words) {
        return add(
                "<text class=\"%s\" x=\"%s\" y=\"%s\" text-anchor=\"%s\">%s</text>",
                style, n(x), n(y), anchor, escaped(words));
    }

    /** Writes text that is rotated by 90° to the left about its middle. */
    Svg upwardText(String style, double x, double y, String words) {
        return add(
                "<text class=\"%s\" transform=\"translate(%s %s) rotate(-90)\" text-anchor=\"middle\">%s</text>",
                style, n(x), n(y), escaped(words));
    }

    private Svg add(String format, Object... values) {
        text.append(String.format(Locale.ROOT, format, values)).append('\n');
        return this;
    }

    /** Formats pixels to a tenth. */
    static String n(double value) {
        return String.format(Locale.ROOT, "%.1f", value);
    }

    /** @param style content of the picture's style element; empty within a page that has its own */
    String document(double width, double height, String title, String style) {
        String box = n(width) + " " + n(height);
        return "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" viewBox=\"0 0 " + box
                + "\" role=\"img\">\n<title>"
                + escaped(title) + "</title>\n" + (style.isEmpty() ? "" : "<style>\n" + style + "</style>\n") + text
                + "</svg>\n";
    }
}
