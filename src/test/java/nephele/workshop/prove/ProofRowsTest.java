package nephele.workshop.prove;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.workshop.prove.proof.Proof;
import org.junit.jupiter.api.Test;

/** Every row of docs/proofs.md belongs to an existing proof and states its current claim and the count. */
class ProofRowsTest {
    @Test
    void everyRowHasItsProofsClaimAndSaysOfHowMany() throws IOException {
        List<String> rows = Files.readAllLines(Path.of("docs", "proofs.md")).stream()
                .filter(line -> line.startsWith("| ") && !line.startsWith("| proof |"))
                .toList();
        List<String> stale = new ArrayList<>();
        for (String row : rows) {
            String[] cells = row.split(" \\| ");
            Proof proof = Proofs.ALL.stream()
                    .filter(of -> ("| " + of.claim().name()).equals(cells[0]))
                    .findFirst()
                    .orElseThrow(() -> new AssertionError("there is no such proof: " + row));
            String full = String.format(
                    Locale.ROOT,
                    "%,d %s",
                    proof.claim().fullCount(),
                    proof.claim().unit());
            boolean says = cells[2].equals(full) || cells[2].endsWith(" of " + full);
            if (!cells[1].equals(proof.claim().sentence()) || !says) {
                stale.add(proof.claim().name() + ": " + cells[1] + " " + cells[2]);
            }
        }
        assertEquals(List.of(), stale);
        assertTrue(rows.size() > 15, "rows " + rows.size());
    }
}
