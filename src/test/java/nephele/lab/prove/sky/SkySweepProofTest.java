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
        ProofResult hours = proof.run(SkySweepProof.SWEEP_UNITS, 1, Proof.Progress.NONE);
        assertEquals(List.of(), horizon.and(hours).examples());
        assertEquals(2 * SkySweepProof.STEPS, horizon.and(hours).value("steps"));
        assertTrue(horizon.value("greatest change in a step") > 0.1, "the sun does rise");
    }
}
