package nephele.workshop.prove.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The proof holds at a small part of the full count. */
@Execution(ExecutionMode.CONCURRENT)
class TerrainProofTest {
    @Test
    void nothingFallsThroughTheGround() {
        ProofResult result = new TerrainProof().run(0, 4000, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertEquals(0, result.failures());
    }
}
