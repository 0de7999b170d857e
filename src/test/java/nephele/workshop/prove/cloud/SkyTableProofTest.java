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
class SkyTableProofTest {
    /** Noon and sunset on the ground, dusk and the limb from high up, and one at random. */
    private static final int[] UNITS = {1, 4, 11, 18, 40};

    @Test
    void theTableFollowsTheIntegrationOverTheWholeDome() {
        SkyTableProof proof = new SkyTableProof();
        ProofResult result = ProofResult.NOTHING;
        for (int unit : UNITS) {
            result = result.and(proof.run(unit, 1, Proof.Progress.NONE));
        }
        assertEquals(List.of(), result.examples());
        assertEquals(UNITS.length, result.units());
        double rmse = result.value("greatest luminance RMSE");
        assertTrue(rmse > 0.01 && rmse <= 1, "a table has errors: " + rmse);
    }
}
