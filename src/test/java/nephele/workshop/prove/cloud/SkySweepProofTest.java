package nephele.workshop.prove.cloud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class SkySweepProofTest {
    /** The sun at −0.2 to −0.3 degrees, where light changes fastest, and a step of the clock. */
    private static final int[] UNITS = {97, SkySweepProof.SWEEP_UNITS + 90};

    @Test
    void theSkyChangesWithoutJumps() {
        var proof = new SkySweepProof();
        ProofResult horizon =
                proof.run(UNITS[0], 1, Proof.Progress.NONE).and(proof.run(UNITS[1], 1, Proof.Progress.NONE));
        assertEquals(List.of(), horizon.examples());
        assertEquals(SkySweepProof.STEPS + 1, horizon.value("steps"));
        double change = horizon.value("greatest change in a step");
        assertTrue(change > 1 && change <= 2, "the sun does rise: " + change);
    }
}
