package nephele.workshop.prove.cloud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;

class CloudImpostorsProofTest {
    /** The first frames of a flight, small, by one cloud. */
    @Test
    void whatImpostorsShowIsWithinAPixel() {
        var proof = new CloudImpostorsProof("levels/samples/clouds-particles.json", 96, 54, 9);
        ProofResult all = proof.run(0, 1, Proof.Progress.NONE);
        assertEquals(List.of(), all.examples());
        double difference = all.value("all rays, mean difference");
        assertTrue(difference > 0 && difference < 0.01, "impostors are drawn: " + difference);
    }
}
