package nephele.workshop.prove.portals;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The proof holds at a reduced count, in a room each. */
@Execution(ExecutionMode.CONCURRENT)
final class WalkInProofTest {
    private static final int WALKS = 4;

    @Test
    void portalsOfShotsAtEyeHeightAreWalkedInto() throws Exception {
        WalkInProof proof = new WalkInProof();
        ProofResult all = ProofResult.NOTHING;
        for (int room = 0; room < WALKS; room++) {
            all = all.and(proof.run(10 * room, 1, Proof.Progress.NONE));
        }
        assertEquals(List.of(), all.examples());
        for (String walks : List.of("walks", "walks that push", "walks that carry")) {
            assertEquals(all.value(walks), all.value(walks + " through"), walks);
            assertTrue(all.value(walks) > WALKS / 4.0, walks);
        }
        assertTrue(all.value("shots refused") <= 0.1 * all.value("shots"), all.toString());
        assertTrue(all.value("walks without assists through") < WALKS, all.toString());
    }

    /** Shares that are too small refute the claim, each alone. */
    @Test
    void tooFewWalksOrTooManyRefusalsAreFailures() {
        for (int[] sums : new int[][] {
            {0, 0, 0, 0, 0}, {21, 0, 0, 0, 1}, {20, 5, 10, 10, 0}, {0, 6, 0, 0, 1}, {0, 0, 11, 0, 1}, {0, 0, 0, 11, 1}
        }) {
            ProofResult result = new ProofResult(
                    1000,
                    0,
                    List.of(
                            Figure.sum("shots", 1000, ""),
                            Figure.sum("shots refused", sums[0], ""),
                            Figure.sum("walks", 1000, ""),
                            Figure.sum("walks through", 1000 - sums[1], ""),
                            Figure.sum("walks that push", 1000, ""),
                            Figure.sum("walks that push through", 1000 - sums[2], ""),
                            Figure.sum("walks that carry", 1000, ""),
                            Figure.sum("walks that carry through", 1000 - sums[3], "")),
                    List.of());
            assertEquals(sums[4], new WalkInProof().judged(result).failures());
        }
    }
}
