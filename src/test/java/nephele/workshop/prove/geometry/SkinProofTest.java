package nephele.workshop.prove.geometry;

import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;

/** The skin holds in slot, wedge, stairs and needles. {@code prove player-skin} makes 10⁶ moves. */
class SkinProofTest {
    @Test
    void theSkinHolds() {
        ProofResult result = new SkinProof().run(0, 10, Proof.Progress.NONE);
        assertTrue(result.holds(), () -> String.join("\n", result.examples()));
        double leastMillimetres = result.figures().get(1).value();
        assertTrue(leastMillimetres < 1.01, "nothing was ever touched");
    }
}
