package nephele.workshop.prove.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Rays against boxes, planes and seams are right, at a hundredth of the full count. */
@Execution(ExecutionMode.CONCURRENT)
class RayProofTest {
    @Test
    void noRayGoesWhereItShouldNot() {
        ProofResult result = new RayProof().run(0, 10_000, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertEquals(0, result.failures());
        double walls = result.figures().get(1).value();
        double met = result.figures().get(2).value();
        assertEquals(7500, walls);
        assertTrue(met > 1000 && met < 9000, met + " boxes met");
    }
}
