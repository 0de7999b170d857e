package nephele.workshop.prove.editor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** A few kills of short sessions lose nothing that was on disk; {@code prove journal-kills} has a hundred long ones. */
@Execution(ExecutionMode.CONCURRENT)
class JournalKillProofTest {
    @Test
    void aKilledSessionIsRecovered() throws Exception {
        ProofResult result = new JournalKillProof(0.6).run(0, 3, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertTrue(result.value("edits made") > 3, result.toString());
    }

    @Test
    void aLossOfMoreThanTwoSecondsRefutesTheClaim() {
        var proof = new JournalKillProof(1);
        var small = ProofResult.of(1, List.of(), Figure.greatest("work lost at most", 1.9, "s"));
        var great = ProofResult.of(1, List.of(), Figure.greatest("work lost at most", 2.1, "s"));
        assertTrue(proof.judged(small).holds());
        assertEquals(1, proof.judged(great).failures());
    }
}
