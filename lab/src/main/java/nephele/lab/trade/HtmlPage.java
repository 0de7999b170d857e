package nephele.lab.trade;

import java.io.IOException;
import java.util.List;
import java.util.stream.Collectors;

/** The report as one page that needs no other file and no network. */
final class HtmlPage {
    private static final String LEAD =
            "Each knob of the engine, set to everything it offers: what it costs, how far the result is from the exact"
                    + " twin, and which setting to choose. Costs are process CPU, every setting timed in turn with the"
                    + " others; what is compared are ratios within a round, so other work on the machine cancels."
                    + " Milliseconds of different knobs were taken at different times: compare the ratios.";

    private HtmlPage() {}

    /** @param opening a section before the findings, as HTML; may be empty */
    static String of(List<Findings> all, Circumstances made, Pictures pictures, String opening) throws IOException {
        var body = new StringBuilder();
        for (Findings findings : all) {
            body.append(new HtmlSubject(findings, pictures).html());
        }
        String title = "Speed against accuracy: " + made.level();
        return HtmlDocument.of(
                title,
                "<header>\n<h1>" + text(title) + "</h1>\n<p class=\"lead\">" + LEAD + "</p>\n" + facts(made, all)
                        + "</header>\n<main>\n" + opening + glance(all) + body + "</main>\n" + footer() + "<script>\n"
                        + HtmlDocument.resource("page.js") + "</script>\n");
    }

    private static String facts(Circumstances made, List<Findings> all) {
        int least = all.stream().mapToInt(Findings::rounds).min().orElse(0);
        return "<p class=\"facts\"><b>" + text(made.levelFile()) + "</b>, " + text(made.picture()) + " · "
                + text(made.machine()) + " · " + (made.graphics().isEmpty() ? "" : text(made.graphics()) + " · ")
                + "commit <b>" + text(made.commit())
                + "</b> · "
                + text(made.date()) + " · " + least + " rounds, each setting twice a round</p>\n";
    }

    private static String glance(List<Findings> all) {
        String rows = all.stream().map(HtmlPage::glanceRow).collect(Collectors.joining("\n"));
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
                + text(trade.text().title()) + "</a></td><td><b>"
                + text(chosen.setting().name()) + "</b></td><td>"
                + Numbers.of(chosen.cost().estimate(), trade.cost().unit()) + "</td><td>× "
                + Numbers.ratio(chosen.ratio().estimate()) + "</td><td>"
                + text(Numbers.of(chosen.error(), trade.error().unit()) + " "
                        + trade.error().name()) + "</td><td>"
                + (never.isEmpty() ? "–" : text(never)) + "</td></tr>";
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

    private static String text(String plain) {
        return HtmlDocument.text(plain);
    }
}
