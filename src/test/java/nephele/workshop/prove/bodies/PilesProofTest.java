package nephele.workshop.prove.bodies;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;

class PilesProofTest {
    private final PilesProof proof = new PilesProof(0);

    @Test
    void pilesStandRestAndSinkIntoNothing() {
        ProofResult result = proof.judged(proof.run(0, 24, Proof.Progress.NONE));
        assertEquals(0, result.failures(), () -> String.join("\n", result.examples()));
        assertEquals(8, result.figure("big piles").orElseThrow().value());
    }

    private static ProofResult towers(int piles, int standing) {
        List<Figure> sums = List.of(
                Figure.sum("tower piles", piles, ""),
                Figure.sum("tower at_rest", piles, ""),
                Figure.sum("tower stands", standing, ""),
                Figure.sum("tower cpu", 1.2, "s"),
                Figure.greatest("tower max_speed", 3, "m/s"));
        return new ProofResult(piles, 0, sums, List.of());
    }

    /** Sums over batches become fractions of the piles, and microseconds a step. */
    @Test
    void figuresAreSharesOfTheFamily() {
        ProofResult judged = proof.judged(towers(100, 99));
        assertEquals(0, judged.failures());
        assertEquals(.99, judged.figure("tower stands").orElseThrow().value(), 1e-12);
        assertEquals(100, judged.figure("tower piles").orElseThrow().value());
        assertEquals(10, judged.figure("tower cpu_us_per_step").orElseThrow().value(), 1e-9);
        assertEquals(3, judged.figure("tower max_speed").orElseThrow().value());
    }

    @Test
    void twoFallenTowersOfAHundredAreTooMany() {
        ProofResult judged = proof.judged(towers(100, 98));
        assertEquals(2, judged.failures());
        assertTrue(judged.examples().get(0).startsWith("tower stands"), judged.examples()::toString);
    }
}
