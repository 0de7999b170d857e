package nephele.lab.prove.sky;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.lab.prove.proof.Proof;
import nephele.lab.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;

class SkySweepProofTest {
    private static final int AT_HORIZON = 99;

    @Test
    void theSkyChangesWithoutJumps() {
        var proof = new SkySweepProof();
        ProofResult horizon = proof.run(AT_HORIZON, 1, Proof.Progress.NONE);
        assertEquals(List.of(), horizon.examples());
        assertEquals(SkySweepProof.STEPS, horizon.value("steps"));
        double change = horizon.value("greatest change in a step");
        assertTrue(change > 0.1 && change <= 2, "the sun does rise: " + change);
    }
}
