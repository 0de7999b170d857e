package nephele.lab.prove.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.lab.prove.proof.Proof;
import nephele.lab.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The proof holds at a small part of its full count. */
@Execution(ExecutionMode.CONCURRENT)
class SaveKillProofTest {
    @Test
    void fiveKillsLeaveReadableLevels() throws Exception {
        ProofResult result = new SaveKillProof().run(0, 5, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertEquals(5, result.units());
        assertEquals(0, result.failures());
    }

    /** Only a kill after a save has begun and before it has ended counts. */
    @Test
    void aKillBetweenTwoSavesIsNoneWithinOne() {
        assertTrue(SaveKillProof.isWithinASave("()()("));
        assertFalse(SaveKillProof.isWithinASave("()()"));
        assertFalse(SaveKillProof.isWithinASave(""));
    }
}
