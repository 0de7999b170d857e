package nephele.workshop.prove.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;

/** View angles and rotations are right, at a tenth of the full count. */
class RotationProofTest {
    @Test
    void turnsAreAsAsked() {
        ProofResult result = new RotationProof().run(0, 100_000, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertEquals(0, result.failures());
    }
}
