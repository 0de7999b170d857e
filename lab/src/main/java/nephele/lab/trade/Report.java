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

/** Writes all files of a report. */
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

    private Report() {}

    public static void write(List<Findings> all, Circumstances made, Path folder) throws IOException {
        write(all, made, "", folder);
    }

    /** @param opening a section before the findings, as HTML */
    public static void write(List<Findings> all, Circumstances made, String opening, Path folder) throws IOException {
        text(folder.resolve("trade.csv"), csv(all));
        for (Findings findings : all) {
            text(
                    folder.resolve("plots").resolve(findings.trade().subject() + ".svg"),
                    CostErrorPlot.of(findings, HtmlDocument.resource(PAGE_STYLE)));
        }
        text(folder.resolve("index.html"), HtmlPage.of(all, made, new Pictures(folder), opening));
    }

    private static void text(Path file, String content) throws IOException {
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
}
