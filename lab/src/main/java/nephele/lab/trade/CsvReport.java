package nephele.lab.trade;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** All findings as CSV, one line a setting. */
final class CsvReport {
    /** The most figures that a subject has. */
    private static final int FIGURES = 7;

    static final String HEADER =
            "subject,setting,usual,recommended,dominatedBy,errorName,errorUnit,error,costName,costUnit,"
                + "cost,costLow,costHigh,ratioToUsual,ratioLow,ratioHigh,wallMs,wallMsLow,wallMsHigh,allocatedBytes,rounds,"
                    + IntStream.rangeClosed(1, FIGURES)
                            .mapToObj(figure -> "figure" + figure + "Name,figure" + figure)
                            .collect(Collectors.joining(","));

    private CsvReport() {}

    static String of(List<Findings> all) {
        List<String> lines = new ArrayList<>(List.of(HEADER));
        for (Findings findings : all) {
            findings.settings().forEach(setting -> lines.add(line(findings, setting)));
        }
        return String.join("\n", lines) + "\n";
    }

    private static String line(Findings findings, SettingFindings setting) {
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
        for (int figure = 0; figure < FIGURES; figure++) {
            boolean there = figure < setting.figures().size();
            cells.add(there ? trade.figures().get(figure) : "");
            cells.add(there ? setting.figures().get(figure) : "");
        }
        return cells.stream().map(CsvReport::cell).collect(Collectors.joining(","));
    }

    private static String cell(Object value) {
        if (value instanceof Double number) {
            return number == Math.rint(number) && Math.abs(number) < 1e15
                    ? String.format(Locale.ROOT, "%.0f", number)
                    : String.format(Locale.ROOT, "%.6g", number);
        }
        String text = value.toString();
        return text.matches("[^,\"\n]*") ? text : "\"" + text.replace("\"", "\"\"") + "\"";
    }
}
