package nephele.lab.trade;

import java.io.IOException;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** A subject's section of the page: description, recommendation, plot, table, pictures. */
final class HtmlSubject {
    private static final String KEY =
            """
            <p class="key">Lower left is better. Ring: recommended. Filled: worth having (Pareto front). Hollow: dominated. \
            Bars: 95&nbsp;% intervals.</p>
            """;

    private final Findings findings;
    private final Trade trade;
    private final Pictures pictures;

    HtmlSubject(Findings findings, Pictures pictures) {
        this.findings = findings;
        this.pictures = pictures;
        trade = findings.trade();
    }

    String html() throws IOException {
        var advice = new Advice(findings);
        return "<section id=\"" + trade.subject() + "\">\n<h2>"
                + text(trade.text().title()) + "</h2>\n<p class=\"about\">"
                + text(trade.text().about()) + " Compared with "
                + text(trade.text().exact()) + ".</p>\n"
                + "<div class=\"two\"><div>" + CostErrorPlot.of(findings, "") + KEY + "</div>\n<div class=\"tell\"><p>"
                + text(advice.choice()) + "</p><ul>"
                + advice.remarks().stream()
                        .map(remark -> "<li>" + text(remark) + "</li>")
                        .collect(Collectors.joining())
                + "</ul></div></div>\n" + table() + viewer() + "</section>\n";
    }

    private String table() {
        var head = new StringBuilder("<tr><th>setting</th>");
        for (String title :
                new String[] {trade.cost().name() + ", " + trade.cost().unit(), "cost, times the usual", withUnit(trade)
                }) {
            head.append("<th>").append(text(title)).append("</th>");
        }
        trade.figures()
                .forEach(figure -> head.append("<th>").append(text(figure)).append("</th>"));
        head.append("<th>bytes allocated each</th></tr>");
        return "<div class=\"wide\"><table>" + head
                + findings.settings().stream().map(this::row).collect(Collectors.joining("\n")) + "</table></div>";
    }

    private static String withUnit(Trade trade) {
        return trade.error().name()
                + (trade.error().unit().isEmpty() ? "" : ", " + trade.error().unit());
    }

    private String row(SettingFindings setting) {
        boolean picked = setting == findings.recommended();
        String style = picked ? "pick" : setting.isOnFront() ? "" : "off";
        var row = new StringBuilder("<tr class=\"" + style + "\"><td><b>"
                + text(setting.setting().name()) + "</b> " + badge(setting, picked) + "<span class=\"note\">"
                + text(
                        setting == findings.usual()
                                ? "usual; " + setting.setting().note()
                                : setting.setting().note())
                + "</span></td>");
        cell(row, Numbers.of(setting.cost().estimate()), Numbers.range(setting.cost()));
        cell(row, Numbers.ratio(setting.ratio().estimate()), Numbers.ratio(setting.ratio()));
        cell(row, Numbers.of(setting.error()), "");
        setting.figures().forEach(figure -> cell(row, Numbers.of(figure), ""));
        cell(row, Numbers.of(setting.bytes()), "");
        return row.append("</tr>").toString();
    }

    private String badge(SettingFindings setting, boolean picked) {
        if (picked) {
            return "<span class=\"badge pick\">choose</span>";
        }
        if (setting.hasPicture() && isAsAnother(setting)) {
            return "<span class=\"badge\">same picture</span>";
        }
        return setting.isOnFront()
                ? "<span class=\"badge\">front</span>"
                : "<span class=\"badge off\">dominated by "
                        + text(trade.settings()
                                .get(setting.dominatedBy().orElseThrow())
                                .name()) + "</span>";
    }

    private boolean isAsAnother(SettingFindings setting) {
        return findings.settings().stream()
                .anyMatch(other -> other != setting
                        && other.error() == setting.error()
                        && other.figures().equals(setting.figures()));
    }

    private static void cell(StringBuilder row, String value, String range) {
        row.append("<td>").append(value);
        if (!range.isEmpty()) {
            row.append("<span class=\"range\">").append(range).append("</span>");
        }
        row.append("</td>");
    }

    private String viewer() throws IOException {
        if (!findings.settings().get(0).hasPicture()) {
            return "";
        }
        var hidden = new StringBuilder();
        for (int setting = 0; setting < trade.settings().size(); setting++) {
            String name = trade.settings().get(setting).name();
            String shown = Pictures.dataAddress(pictures.shown(trade, setting));
            hidden.append(hidden(setting, "shown", name, shown));
            String error = Pictures.dataAddress(pictures.error(trade, setting));
            hidden.append(hidden(setting, "flip", name + ": where it differs", error));
        }
        int picked = findings.settings().indexOf(findings.recommended());
        String buttons = IntStream.range(0, trade.settings().size())
                .mapToObj(setting -> "<button data-shown=\"" + setting + "\" aria-pressed=\"" + (setting == picked)
                        + "\">" + text(trade.settings().get(setting).name()) + "</button>")
                .collect(Collectors.joining());
        return """
                <div class="viewer"><div class="bar"><span class="group">Setting %s</span>
                <span class="group">Show <button data-kind="shown" aria-pressed="true">picture</button>\
                <button data-kind="flip" aria-pressed="false">where it differs</button>\
                <span class="heat" style="background:linear-gradient(90deg,%s)"></span>FLIP 0 to 1</span></div>
                <div class="wipe"><img alt="the exact picture" src="%s"><img class="over" alt="the setting's picture">\
                <span class="seam"></span><span class="tag left">exact</span><span class="tag right"></span>\
                <input type="range" min="0" max="100" value="50" step="0.1" aria-label="Wipe between exact and setting"></div>
                <div class="all" hidden>%s</div></div>
                """
                .formatted(buttons, Pictures.heatGradient(), Pictures.dataAddress(pictures.exact(trade)), hidden);
    }

    private static String hidden(int setting, String kind, String caption, String address) {
        return "<figure><img alt=\"\" data-of=\"" + setting + "\" data-is=\"" + kind + "\" src=\"" + address
                + "\"><figcaption>" + text(caption) + "</figcaption></figure>";
    }

    private static String text(String plain) {
        return HtmlDocument.text(plain);
    }
}
