package nephele.lab.trade;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;

/**
 * A plot of cost (x) against error (y); the best corner is the lower left. Bars are intervals of 95 %. The line joins
 * the settings on the Pareto front, hollow points are dominated, and the recommended point has a ring.
 */
final class CostErrorPlot {
    private static final double WIDTH = 560;
    private static final double HEIGHT = 340;
    private static final double LEFT = 74;
    private static final double RIGHT = 22;
    private static final double TOP = 22;
    private static final double BOTTOM = 54;
    private static final double LETTER = 7.2;
    private static final double LINE = 15;

    private final Findings findings;
    private final Axis cost;
    private final Axis error;
    /** The shapes so far. Colours come from classes, so that a page can be light or dark. */
    private final StringBuilder svg = new StringBuilder();
    /** Left, top, right and bottom of the rectangles that labels must not cover. */
    private final List<double[]> taken = new ArrayList<>();

    private CostErrorPlot(Findings findings) {
        this.findings = findings;
        double least = findings.settings().stream()
                .mapToDouble(setting -> setting.cost().low())
                .min()
                .orElseThrow();
        double most = findings.settings().stream()
                .mapToDouble(setting -> setting.cost().high())
                .max()
                .orElseThrow();
        double worst = findings.settings().stream()
                .mapToDouble(SettingFindings::error)
                .max()
                .orElseThrow();
        cost = Axis.ofCosts(least, most, LEFT, WIDTH - RIGHT);
        error = Axis.ofErrors(worst, HEIGHT - BOTTOM, TOP);
    }

    /** @param style see {@link #document} */
    static String of(Findings findings, String style) {
        var plot = new CostErrorPlot(findings);
        plot.axes();
        plot.front();
        plot.settings();
        String title = findings.trade().text().title() + ": cost against error";
        return plot.document(WIDTH, HEIGHT, title, style);
    }

    private void axes() {
        for (double tick : cost.ticks()) {
            line("grid", cost.pixel(tick), TOP, cost.pixel(tick), HEIGHT - BOTTOM);
            text("tick", cost.pixel(tick), HEIGHT - BOTTOM + 18, "middle", Numbers.of(tick));
        }
        for (double tick : error.ticks()) {
            line("grid", LEFT, error.pixel(tick), WIDTH - RIGHT, error.pixel(tick));
            text("tick", LEFT - 8, error.pixel(tick) + 4, "end", Numbers.of(tick));
        }
        line("axis", LEFT, HEIGHT - BOTTOM, WIDTH - RIGHT, HEIGHT - BOTTOM);
        line("axis", LEFT, TOP, LEFT, HEIGHT - BOTTOM);
        var trade = findings.trade();
        String costWords = trade.cost().name() + ", " + trade.cost().unit() + costScale();
        text("label", (LEFT + WIDTH - RIGHT) / 2, HEIGHT - 12, "middle", costWords + " →");
        String unit = trade.error().unit();
        upwardText(
                "label",
                18,
                (TOP + HEIGHT - BOTTOM) / 2,
                trade.error().name() + (unit.isEmpty() ? "" : ", " + unit) + " →");
    }

    private String costScale() {
        return cost.isLogarithmic() ? " (logarithmic)" : cost.low() > 0 ? " (not from zero)" : "";
    }

    private void front() {
        StringBuilder d = new StringBuilder();
        findings.settings().stream()
                .filter(SettingFindings::isOnFront)
                .sorted(Comparator.comparingDouble(setting -> setting.cost().estimate()))
                .forEach(setting -> d.append(d.length() == 0 ? "M" : " L")
                        .append(n(x(setting)))
                        .append(' ')
                        .append(n(y(setting))));
        path("front", d.toString());
    }

    private void settings() {
        for (SettingFindings setting : findings.settings()) {
            taken.add(new double[] {x(setting) - 8, y(setting) - 8, x(setting) + 8, y(setting) + 8});
        }
        findings.settings().stream().sorted(Comparator.comparingDouble(this::x)).forEach(this::draw);
    }

    private void draw(SettingFindings setting) {
        String kind = setting.isOnFront() ? "good" : "dominated";
        line(
                "interval " + kind,
                cost.pixel(setting.cost().low()),
                y(setting),
                cost.pixel(setting.cost().high()),
                y(setting));
        if (setting == findings.recommended()) {
            circle("ring", x(setting), y(setting), 10, "recommended");
        }
        circle("point " + kind, x(setting), y(setting), 5, title(setting));
        label(setting, kind);
    }

    private String title(SettingFindings setting) {
        var trade = findings.trade();
        return setting.setting().name() + ": "
                + Numbers.of(setting.cost().estimate(), trade.cost().unit()) + " ("
                + Numbers.range(setting.cost()) + "), " + trade.error().name() + " "
                + Numbers.of(setting.error(), trade.error().unit());
    }

    /**
     * Writes a setting's name above its point, or higher if that place is taken; a thin line joins a distant label to
     * its point.
     */
    private void label(SettingFindings setting, String kind) {
        String words = setting.setting().name();
        double width = LETTER * words.length();
        double left = Math.min(Math.max(x(setting) - width / 2, LEFT + 4), WIDTH - RIGHT - width);
        double bottom = y(setting) - 12;
        while (isTaken(left, bottom, width) && bottom > TOP + LINE) {
            bottom -= LINE;
        }
        if (isTaken(left, bottom, width)) {
            bottom = y(setting) + 24;
        }
        taken.add(new double[] {left, bottom - LINE, left + width, bottom});
        if (bottom < y(setting) - 20) {
            line("leader", x(setting), y(setting) - 8, left + width / 2, bottom + 3);
        }
        text("name " + kind, left + width / 2, bottom, "middle", words);
    }

    private boolean isTaken(double left, double bottom, double width) {
        return taken.stream()
                .anyMatch(box -> left < box[2] && left + width > box[0] && bottom - LINE < box[3] && bottom > box[1]);
    }

    private double x(SettingFindings setting) {
        return cost.pixel(setting.cost().estimate());
    }

    private double y(SettingFindings setting) {
        return error.pixel(setting.error());
    }

    private void line(String style, double x1, double y1, double x2, double y2) {
        add("<line class=\"%s\" x1=\"%s\" y1=\"%s\" x2=\"%s\" y2=\"%s\"/>", style, n(x1), n(y1), n(x2), n(y2));
    }

    private void path(String style, String d) {
        add("<path class=\"%s\" d=\"%s\"/>", style, d);
    }

    /** @param title shown when the pointer is over the circle */
    private void circle(String style, double x, double y, double radius, String title) {
        add(
                "<circle class=\"%s\" cx=\"%s\" cy=\"%s\" r=\"%s\"><title>%s</title></circle>",
                style, n(x), n(y), n(radius), HtmlDocument.text(title));
    }

    /** @param anchor start, middle or end */
    private void text(String style, double x, double y, String anchor, String words) {
        add(
                "<text class=\"%s\" x=\"%s\" y=\"%s\" text-anchor=\"%s\">%s</text>",
                style, n(x), n(y), anchor, HtmlDocument.text(words));
    }

    /** Writes text that is rotated by 90° to the left about its middle. */
    private void upwardText(String style, double x, double y, String words) {
        add(
                "<text class=\"%s\" transform=\"translate(%s %s) rotate(-90)\" text-anchor=\"middle\">%s</text>",
                style, n(x), n(y), HtmlDocument.text(words));
    }

    private void add(String format, Object... values) {
        svg.append(String.format(Locale.ROOT, format, values)).append('\n');
    }

    /** Formats pixels to a tenth. */
    private static String n(double value) {
        return String.format(Locale.ROOT, "%.1f", value);
    }

    /** @param style content of the picture's style element; empty within a page that has its own */
    private String document(double width, double height, String title, String style) {
        String box = n(width) + " " + n(height);
        return "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" viewBox=\"0 0 " + box
                + "\" role=\"img\">\n<title>"
                + HtmlDocument.text(title) + "</title>\n" + (style.isEmpty() ? "" : "<style>\n" + style + "</style>\n")
                + svg
                + "</svg>\n";
    }
}
