package nephele.workshop.prove.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;

/** The separation of shapes and solids equals that of brute force, at a hundredth of the full count. */
class SeparationProofTest {
    @Test
    void shapesMeetAsBruteForceSays() {
        ProofResult result = new SeparationProof().run(0, 10_000, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertEquals(0, result.failures());
    }
}
