package nephele.workshop.prove;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.TextFile;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * The file docs/proofs.md: one row a proof; failing rows first, then those that state a part of their count, else in the
 * order of {@link Proofs#ALL}. A new result replaces the old row.
 */
public final class ProofTable {
    private static final String HEAD =
            """
            # Proofs

            `nephele prove` writes this table. Each row is the last run of one proof, at full count unless the row states a part of it. `nephele prove NAME` repeats the proof. Failing rows come first, then those of a part.

            `gradle/proofs.sh` says how old the rows are: it counts, for each, the commits since the row's own that touched one of the proof's packages.

            | proof | claim | count | failures | figures | date | commit | machine |
            |---|---|---|---|---|---|---|---|
            """;

    private final Path file;

    public ProofTable(Path file) {
        this.file = file;
    }

    /**
     * Writes the result into the table in place of the proof's earlier row.
     *
     * @param date of the result, {@code commit} and {@code machine} likewise
     */
    public void write(Proof proof, ProofResult result, String date, String commit, String machine) throws IOException {
        var rows = rows();
        rows.removeIf(row -> nameOf(row).equals(proof.claim().name()));
        rows.add(row(proof, result, date, commit, machine));
        var order = Proofs.ALL.stream().map(of -> of.claim().name()).collect(Collectors.toList());
        rows.sort(Comparator.comparingInt(ProofTable::rank).thenComparingInt(row -> place(order.indexOf(nameOf(row)))));
        AtomicFile.write(file, (HEAD + String.join("\n", rows) + "\n").getBytes(StandardCharsets.UTF_8));
    }

    /** Returns 0 for a row with failures, 1 for one that states a part of its count, 2 for the others. */
    private static int rank(String row) {
        String[] cells = row.split(" \\| ");
        return !cells[3].equals("0") ? 0 : cells[2].matches("[0-9,]+ of [0-9,]+ .*") ? 1 : 2;
    }

    private static int place(int index) {
        return index < 0 ? Integer.MAX_VALUE : index;
    }

    private List<String> rows() throws IOException {
        if (!Files.exists(file)) {
            return new ArrayList<>();
        }
        return TextFile.lines(file).stream()
                .filter(line -> line.startsWith("| ") && !line.startsWith("| proof |"))
                .collect(Collectors.toCollection(ArrayList::new));
    }

    private static String nameOf(String row) {
        return row.split("\\|")[1].strip();
    }

    private static String row(Proof proof, ProofResult result, String date, String commit, String machine) {
        var figures = result.figures().stream().map(ProofTable::text).collect(Collectors.joining("; "));
        return "| "
                + String.join(
                        " | ",
                        proof.claim().name(),
                        proof.claim().sentence(),
                        count(proof, result),
                        Long.toString(result.failures()),
                        figures,
                        date,
                        commit,
                        machine)
                + " |";
    }

    private static String count(Proof proof, ProofResult result) {
        String of = result.units() < proof.claim().fullCount()
                ? String.format(Locale.ROOT, " of %,d", proof.claim().fullCount())
                : "";
        return String.format(
                Locale.ROOT, "%,d%s %s", result.units(), of, proof.claim().unit());
    }

    /** Returns the result for the terminal: verdict, count, figures and the first failures. */
    public static String summary(Proof proof, ProofResult result) {
        var verdict = result.holds() ? "holds" : "FAILS (" + result.failures() + " failures)";
        var text = new StringBuilder(
                String.format(Locale.ROOT, "%s: %s after %s", proof.claim().name(), verdict, count(proof, result)));
        result.figures().forEach(figure -> text.append("\n  ").append(text(figure)));
        result.examples().forEach(example -> text.append("\n  failed: ").append(example));
        return text.toString();
    }

    /** Formats a figure: whole numbers whole, others with five digits. */
    static String text(Figure figure) {
        boolean whole = figure.value() == Math.rint(figure.value()) && Math.abs(figure.value()) < 1e15;
        String number = String.format(Locale.ROOT, whole ? "%,.0f" : "%.5g", figure.value());
        return (figure.name() + " " + number + " " + figure.unit()).strip();
    }
}
