package nephele.workshop.prove.portals;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** A surface cut into other triangles gives the same place, at a hundredth of the full count. */
@Execution(ExecutionMode.CONCURRENT)
class RetriangulationProofTest {
    @Test
    void thePortalComesToTheSamePlace() {
        ProofResult result = new RetriangulationProof().run(0, 100, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertEquals(0, result.failures());
        double compared = result.figures().get(0).value();
        double placed = result.figures().get(1).value();
        assertTrue(
                compared > 150 && placed > 50 && placed < compared - 50, compared + " shots, " + placed + " portals");
    }

    /** The longest piece of the upper edge is inclined enough to have been mistaken for an edge of its own. */
    @Test
    void aLeaningLongestPieceMakesNoStep() {
        ProofResult result = new RetriangulationProof().run(6552, 1, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertEquals(5, result.figures().get(0).value());
    }
}
