package nephele.workshop.prove.portals;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Nearest places on walls are no worse than those of brute force, at a hundredth of the full count. */
@Execution(ExecutionMode.CONCURRENT)
class PlacementProofTest {
    @Test
    void noBetterAnswerIsFound() {
        ProofResult result = new PlacementProof().run(0, 1_000, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertEquals(0, result.failures());
        double placed = result.figures().get(0).value();
        double slid = result.figures().get(1).value();
        assertTrue(placed > 200 && placed < 800, placed + " portals");
        assertTrue(slid > 100 && slid < placed, slid + " slid");
    }

    /** Shots beside the tips of holes of 5.6° are right; these tips were once mistaken for cracks of noise. */
    @Test
    void tipsOfSharpHolesCount() {
        for (long shot : new long[] {65_519, 89_653}) {
            assertEquals(
                    List.of(),
                    new PlacementProof().run(shot, 1, Proof.Progress.NONE).examples());
        }
    }
}
