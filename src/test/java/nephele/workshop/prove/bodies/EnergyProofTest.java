package nephele.workshop.prove.bodies;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class EnergyProofTest {
    @Test
    void droppedPilesGainNoEnergyAndSinkIntoNothing() {
        EnergyProof proof = new EnergyProof();
        ProofResult result = proof.judged(proof.run(0, 36, Proof.Progress.NONE));
        assertEquals(0, result.failures(), () -> String.join("\n", result.examples()));
        assertTrue(result.figure("bodies through portals").orElseThrow().value() > 5);
    }

    private static ProofResult shares(double little, double awake) {
        List<Figure> sums = List.of(
                Figure.sum("piles", 3000, ""),
                Figure.sum("violations at 1 mm", little, ""),
                Figure.sum("piles without portals", 2000, ""),
                Figure.sum("awake", awake, ""));
        return new ProofResult(3000, 0, sums, List.of());
    }

    /**
     * One in a thousand piles may exceed the limit of 1 mm, and one in a thousand of those without portals may remain
     * awake.
     */
    @Test
    void sharesAreJudgedOverAllBatches() {
        assertTrue(new EnergyProof().judged(shares(3, 2)).holds());
        assertEquals(4, new EnergyProof().judged(shares(4, 2)).failures());
        assertEquals(3, new EnergyProof().judged(shares(3, 3)).failures());
    }
}
