package nephele.workshop.prove.portals;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The proof holds at a tenth of the traversals. */
@Execution(ExecutionMode.CONCURRENT)
final class TraversalsProofTest {
    @Test
    void traversalsAddNothing() {
        ProofResult result = new TraversalsProof().run(0, 100_000, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertEquals(0, result.failures());
    }
}
