package nephele.workshop.prove.cloud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;

class CloudFlightProofTest {
    /** A few frames of the coarsest preset, under the cheapest clouds. */
    @Test
    void framesThatShareRaysStepAsFramesOfAllRays() {
        var proof = new CloudFlightProof("levels/samples/clouds-ellipsoid.json", 96, 54, 6);
        ProofResult low = proof.run(0, 1, Proof.Progress.NONE);
        assertEquals(List.of(), low.examples());
        double error = low.value("low, mean error");
        assertTrue(error > 0 && error < 0.05, "rays are shared: " + error);
        assertEquals(0, low.value("low, ghost 0 frames after a cut"));
    }
}
