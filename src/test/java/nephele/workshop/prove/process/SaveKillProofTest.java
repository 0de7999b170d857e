package nephele.workshop.prove.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The proof holds at a small part of its full count. */
@Execution(ExecutionMode.CONCURRENT)
class SaveKillProofTest {
    static Stream<Proof> proofs() {
        return Stream.of(SaveKillProof.LEVELS, SaveKillProof.SETTINGS);
    }

    @ParameterizedTest
    @MethodSource("proofs")
    void threeKillsLeaveReadableFiles(Proof proof) throws Exception {
        ProofResult result = proof.run(0, 3, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertEquals(3, result.units());
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
