package nephele.app.prove;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Extremes 1, 16, 18 and 34; C.2 row 23: the proof at a reduced count. */
final class CrossingsProofTest {
    @Test
    void nobodyFallsThroughOrStaysInASolid() {
        ProofResult result = new CrossingsProof().run(0, 300, Proof.Progress.NONE);
        assertEquals(0, result.failures(), () -> String.join("\n", result.examples()));
        double crossings = result.figures().get(0).value();
        assertTrue(crossings > 240, "crossings: " + crossings);
    }
}
