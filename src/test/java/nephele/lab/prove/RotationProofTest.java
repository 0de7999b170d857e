package nephele.lab.prove;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

/** C.2 rows 8 and 13 at a tenth of their full count. */
class RotationProofTest {
    @Test
    void turnsAreAsAsked() {
        ProofResult result = new RotationProof().run(0, 100_000, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertEquals(0, result.failures());
    }
}
