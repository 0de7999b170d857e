package nephele.app.prove;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

/** The proof at a hundredth of its full count. */
class SaveKillProofTest {
    @Test
    void tenKillsLeaveTenReadableLevels() throws Exception {
        ProofResult result = new SaveKillProof().run(0, 10, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertEquals(10, result.units());
        assertEquals(0, result.failures());
    }
}
