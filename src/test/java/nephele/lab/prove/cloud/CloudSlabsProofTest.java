package nephele.lab.prove.cloud;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import nephele.lab.prove.proof.Proof;
import nephele.lab.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;

/** Slabs reflect and transmit what the table says, in 24 of its 360 rows. */
class CloudSlabsProofTest {
    @Test
    void slabsReflectAndTransmitWhatTheTableSays() {
        ProofResult result = new CloudSlabsProof().run(0, 24, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertEquals(24 * 4, result.value("fluxes"));
    }
}
