package nephele.workshop.prove;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.LongStream;
import nephele.engine.reference.tile.Shard;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ProofRunTest {
    @TempDir
    Path folder;

    private final List<Long> ran = new ArrayList<>();

    /** A proof that every multiple of seven refutes and that throws once at unit 20. */
    private final class Sevens implements Proof {
        private boolean breaksDown = true;

        @Override
        public Claim claim() {
            return new Claim("sevens", "no number is a multiple of seven", "numbers", 50, 8);
        }

        @Override
        public ProofResult run(long from, long count, Progress progress) {
            var examples = new ArrayList<String>();
            for (long unit = from; unit < from + count; unit++) {
                if (unit == 20 && breaksDown) {
                    breaksDown = false;
                    throw new IllegalStateException("power cut");
                }
                ran.add(unit);
                if (unit % 7 == 0) {
                    progress.failed("number " + unit);
                    examples.add("number " + unit);
                }
            }
            return new ProofResult(
                    count,
                    examples.size(),
                    List.of(
                            Figure.greatest("largest", from + count - 1, ""),
                            Figure.least("smallest", from, "m"),
                            Figure.sum("all", count, "numbers")),
                    examples);
        }
    }

    private ProofRun run(Proof proof) {
        return new ProofRun(proof, folder, new PrintStream(OutputStream.nullOutputStream()));
    }

    @Test
    void aStoppedRunGoesOnAtTheLastBatch() throws Exception {
        var proof = new Sevens();
        assertThrows(IllegalStateException.class, () -> run(proof).upTo(50, "abc"));
        ran.clear();
        var result = run(proof).upTo(50, "abc");
        assertEquals(16, ran.get(0));
        assertEquals(new ProofResult(50, 8, result.figures(), result.examples()), result);
        assertEquals(
                List.of(49.0, 0.0, 50.0),
                result.figures().stream().map(Figure::value).toList());
        assertFalse(result.holds());
    }

    @Test
    void anotherCommitStartsOver() throws Exception {
        var proof = new Sevens();
        proof.breaksDown = false;
        run(proof).upTo(16, "abc");
        ran.clear();
        run(proof).upTo(16, "abc");
        assertTrue(ran.isEmpty());
        run(proof).upTo(16, "def");
        assertEquals(16, ran.size());
    }

    @Test
    void sharesRunEachUnitOnceAndAreJoined() throws Exception {
        var proof = new Sevens();
        proof.breaksDown = false;
        for (int number = 1; number <= 3; number++) {
            var run =
                    new ProofRun(proof, folder, new Shard(number, 3), new PrintStream(OutputStream.nullOutputStream()));
            run.upTo(run.size(), "abc");
            assertEquals(ran.size(), run.joined("abc").units());
            assertEquals(0, run.joined("def").units());
        }
        assertEquals(LongStream.range(0, 50).boxed().toList(), ran);
        run(proof).upTo(50, "abc");
        assertEquals(100, ran.size());
    }

    @Test
    void someUnitsRunAloneAndKeepNothing() throws Exception {
        var proof = new Sevens();
        proof.breaksDown = false;
        run(proof).upTo(8, "abc");
        ran.clear();
        assertEquals(1, run(proof).alone(49, 1).failures());
        assertEquals(List.of(49L), ran);
        run(proof).upTo(9, "abc");
        assertEquals(List.of(49L, 8L), ran);
    }

    @Test
    void aFailureIsNamedAtOnce() throws Exception {
        var shown = new ByteArrayOutputStream();
        var proof = new Sevens();
        new ProofRun(proof, folder, new PrintStream(shown, true)).alone(14, 1);
        assertEquals("sevens: failed: number 14" + System.lineSeparator(), shown.toString());
    }

    @Test
    void theTableKeepsOneRowForAProof() throws Exception {
        var table = new ProofTable(folder.resolve("docs/proofs.md"));
        var proof = new Sevens();
        var result = new ProofResult(50, 0, List.of(Figure.greatest("pause", 1.25, "ms")), List.of());
        table.write(proof, result, "2026-01-01", "abc", "a machine");
        table.write(proof, result, "2026-01-02", "def", "a machine");
        var rows = Files.readAllLines(folder.resolve("docs/proofs.md")).stream()
                .filter(line -> line.startsWith("| sevens "))
                .toList();
        assertEquals(1, rows.size());
        assertTrue(rows.get(0).contains(" | 50 numbers | "), rows.get(0));
        var part = new ProofResult(8, 0, List.of(), List.of());
        table.write(proof, part, "2026-01-03", "fed", "a machine");
        assertTrue(Files.readString(folder.resolve("docs/proofs.md")).contains(" | 8 of 50 numbers | "));
        assertTrue(rows.get(0).contains("| pause 1.2500 ms | 2026-01-02 | def |"), rows.get(0));
    }

    @Test
    void everyRegisteredProofHasANameOfItsOwn() {
        var names = Proofs.ALL.stream().map(proof -> proof.claim().name()).toList();
        assertEquals(names.stream().distinct().toList(), names);
        assertTrue(names.stream().allMatch(name -> name.matches("[a-z]+(-[a-z]+)*")), names.toString());
    }
}
