package nephele.lab.trade;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import nephele.engine.asset.AtomicFile;

/** Writes all files of a report. */
public final class Report {
    /** A plot in a file of its own has the page's style, so that it follows the light or dark theme too. */
    private static final String PAGE_STYLE = "page.css";

    private Report() {}

    public static void write(List<Findings> all, Circumstances made, Path folder) throws IOException {
        write(all, made, "", folder);
    }

    /** @param opening a section before the findings, as HTML */
    public static void write(List<Findings> all, Circumstances made, String opening, Path folder) throws IOException {
        text(folder.resolve("trade.csv"), CsvReport.of(all));
        for (Findings findings : all) {
            text(
                    folder.resolve("plots").resolve(findings.trade().subject() + ".svg"),
                    CostErrorPlot.of(findings, PageFile.read(PAGE_STYLE)));
        }
        text(folder.resolve("index.html"), HtmlPage.of(all, made, new Pictures(folder), opening));
    }

    private static void text(Path file, String content) throws IOException {
        AtomicFile.write(file, content.getBytes(StandardCharsets.UTF_8));
    }
}
