package nephele.workshop.prove.portals;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;

/** No player escapes at up to 10 000 m/s through walls of about 1 cm. {@code prove closed-room} runs 10⁶ starts. */
class ClosedRoomProofTest {
    private final ClosedRoomProof proof = new ClosedRoomProof();

    @Test
    void nobodyEscapes() {
        ProofResult result = proof.run(0, 5000, Proof.Progress.NONE);
        assertTrue(result.holds(), () -> String.join("\n", result.examples()));
    }

    @Test
    void aRangeIsTheSumOfItsParts() {
        ProofResult whole = proof.run(40, 120, Proof.Progress.NONE);
        ProofResult parts = proof.run(40, 70, Proof.Progress.NONE).and(proof.run(110, 50, Proof.Progress.NONE));
        assertEquals(whole, parts);
    }
}
