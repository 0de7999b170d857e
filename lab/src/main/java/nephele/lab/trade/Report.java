package nephele.lab.trade;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import nephele.engine.asset.AtomicFile;

/** Writes all files of a report: a page, and its figures and plots in files of their own. */
public final class Report {
    /** The most figures that a subject has. */
    private static final int CSV_FIGURES = 7;

    static final String CSV_HEADER =
            "subject,setting,usual,recommended,dominatedBy,errorName,errorUnit,error,costName,costUnit,"
                + "cost,costLow,costHigh,ratioToUsual,ratioLow,ratioHigh,wallMs,wallMsLow,wallMsHigh,allocatedBytes,rounds,"
                    + IntStream.rangeClosed(1, CSV_FIGURES)
                            .mapToObj(figure -> "figure" + figure + "Name,figure" + figure)
                            .collect(Collectors.joining(","));

    /** A plot in a file of its own has the page's style, so that it follows the light or dark theme too. */
    private static final String PAGE_STYLE = "page.css";

    private static final String LEAD =
            "Each knob of the engine, set to everything it offers: what it costs, how far the result is from the exact"
                    + " twin, and which setting to choose. Costs are process CPU, every setting timed in turn with the"
                    + " others; what is compared are ratios within a round, so other work on the machine cancels."
                    + " Milliseconds of different knobs were taken at different times: compare the ratios.";

    private Report() {}

    public static void write(List<Findings> all, Circumstances made, Path folder) throws IOException {
        write(all, made, "", folder);
    }

    /** @param opening a section before the findings, as HTML */
    public static void write(List<Findings> all, Circumstances made, String opening, Path folder) throws IOException {
        save(folder.resolve("trade.csv"), csv(all));
        for (Findings findings : all) {
            save(
                    folder.resolve("plots").resolve(findings.trade().subject() + ".svg"),
                    CostErrorPlot.of(findings, HtmlDocument.resource(PAGE_STYLE)));
        }
        save(folder.resolve("index.html"), page(all, made, new Pictures(folder), opening));
    }

    private static void save(Path file, String content) throws IOException {
        AtomicFile.write(file, content.getBytes(StandardCharsets.UTF_8));
    }

    /** All findings as CSV, one line a setting. */
    static String csv(List<Findings> all) {
        List<String> lines = new ArrayList<>(List.of(CSV_HEADER));
        for (Findings findings : all) {
            findings.settings().forEach(setting -> lines.add(csvLine(findings, setting)));
        }
        return String.join("\n", lines) + "\n";
    }

    private static String csvLine(Findings findings, SettingFindings setting) {
        var trade = findings.trade();
        List<Object> cells = new ArrayList<>(List.of(
                trade.subject(),
                setting.setting().name(),
                setting == findings.usual(),
                setting == findings.recommended(),
                setting.dominatedBy().isEmpty()
                        ? ""
                        : trade.settings().get(setting.dominatedBy().getAsInt()).name(),
                trade.error().name(),
                trade.error().unit(),
                setting.error(),
                trade.cost().name(),
                trade.cost().unit()));
        cells.addAll(List.of(
                setting.cost().estimate(),
                setting.cost().low(),
                setting.cost().high(),
                setting.ratio().estimate(),
                setting.ratio().low(),
                setting.ratio().high(),
                setting.wallNanos().estimate() / 1e6,
                setting.wallNanos().low() / 1e6,
                setting.wallNanos().high() / 1e6,
                setting.bytes(),
                (double) findings.rounds()));
        for (int figure = 0; figure < CSV_FIGURES; figure++) {
            boolean there = figure < setting.figures().size();
            cells.add(there ? trade.figures().get(figure) : "");
            cells.add(there ? setting.figures().get(figure) : "");
        }
        return cells.stream().map(Report::csvCell).collect(Collectors.joining(","));
    }

    private static String csvCell(Object value) {
        if (value instanceof Double number) {
            return number == Math.rint(number) && Math.abs(number) < 1e15
                    ? String.format(Locale.ROOT, "%.0f", number)
                    : String.format(Locale.ROOT, "%.6g", number);
        }
        String text = value.toString();
        return text.matches("[^,\"\n]*") ? text : "\"" + text.replace("\"", "\"\"") + "\"";
    }

    /** Returns the report as one page that needs no other file and no network. */
    private static String page(List<Findings> all, Circumstances made, Pictures pictures, String opening)
            throws IOException {
        var body = new StringBuilder();
        for (Findings findings : all) {
            body.append(new HtmlSubject(findings, pictures).html());
        }
        String title = "Speed against accuracy: " + made.level();
        return HtmlDocument.of(
                title,
                "<header>\n<h1>" + HtmlDocument.text(title) + "</h1>\n<p class=\"lead\">" + LEAD + "</p>\n"
                        + facts(made, all)
                        + "</header>\n<main>\n" + opening + glance(all) + body + "</main>\n" + footer() + "<script>\n"
                        + HtmlDocument.resource("page.js") + "</script>\n");
    }

    private static String facts(Circumstances made, List<Findings> all) {
        int least = all.stream().mapToInt(Findings::rounds).min().orElse(0);
        return "<p class=\"facts\"><b>" + HtmlDocument.text(made.levelFile()) + "</b>, "
                + HtmlDocument.text(made.picture()) + " · "
                + HtmlDocument.text(made.machine()) + " · "
                + (made.graphics().isEmpty() ? "" : HtmlDocument.text(made.graphics()) + " · ")
                + "commit <b>" + HtmlDocument.text(made.commit())
                + "</b> · "
                + HtmlDocument.text(made.date()) + " · " + least + " rounds, each setting twice a round</p>\n";
    }

    private static String glance(List<Findings> all) {
        String rows = all.stream().map(Report::glanceRow).collect(Collectors.joining("\n"));
        return "<section><h2>At a glance</h2><div class=\"wide\"><table"
                + " class=\"glance\"><tr><th>knob</th><th>choose</th><th>cost</th><th>of what is"
                + " usual</th><th>error</th><th>never</th></tr>\n" + rows
                + "</table></div></section>\n";
    }

    private static String glanceRow(Findings findings) {
        var chosen = findings.recommended();
        var trade = findings.trade();
        String never = findings.settings().stream()
                .filter(setting -> !setting.isOnFront())
                .map(setting -> setting.setting().name())
                .collect(Collectors.joining(", "));
        return "<tr><td><a href=\"#" + trade.subject() + "\">"
                + HtmlDocument.text(trade.text().title()) + "</a></td><td><b>"
                + HtmlDocument.text(chosen.setting().name()) + "</b></td><td>"
                + Numbers.of(chosen.cost().estimate(), trade.cost().unit()) + "</td><td>× "
                + Numbers.ratio(chosen.ratio().estimate()) + "</td><td>"
                + HtmlDocument.text(Numbers.of(chosen.error(), trade.error().unit()) + " "
                        + trade.error().name()) + "</td><td>"
                + (never.isEmpty() ? "–" : HtmlDocument.text(never)) + "</td></tr>";
    }

    private static String footer() {
        return """
                <footer>FLIP (Andersson et al. 2020, 2021) is what an observer sees who flips between two pictures at 67 pixels a \
                degree: 0 is equal, 1 is black against white. The oracle is the path tracer of “nephele render --reference”; \
                relMSE is the mean squared error over the squared exact value. What is usual is what the preset “high” has, or the \
                game: all costs are measured as ratios to it, so its own has no interval. A setting is dominated when another is \
                clearly cheaper and errs no more, or seems to cost no more and errs clearly less. Clearly cheaper: the 95&nbsp;%% \
                intervals are more than %s&nbsp;%% apart; errors are clearly apart beyond what the subject can tell. Of settings that \
                err by no more than is enough above the best (the figure in the sentence) the cheapest is recommended. Intervals are \
                bootstrapped medians, seeded. The figures are in trade.csv beside this page, the plots in plots/, the pictures \
                without loss in pictures/.</footer>
                """
                .formatted(Math.round(100 * Findings.COST_STEP));
    }
}
