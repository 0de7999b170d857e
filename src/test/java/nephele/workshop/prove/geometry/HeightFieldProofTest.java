package nephele.workshop.prove.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;

/** The proof holds at a small part of the full count, on a smaller large field. */
class HeightFieldProofTest {
    @Test
    void raysAndSweepsMeetWhatATestOfEveryTriangleFinds() {
        ProofResult result = new HeightFieldProof(257).run(0, 120, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertEquals(0, result.failures());
    }
}
