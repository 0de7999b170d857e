package nephele.workshop.prove.bodies;

import static org.junit.jupiter.api.Assertions.assertEquals;

import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The nine stacks hold, each under its load for a second. */
class MassRatiosProofTest {
    @ParameterizedTest
    @ValueSource(longs = {0, 1, 2, 3, 4, 5, 6, 7, 8})
    void lightCubesBearHeavyOnes(long unit) {
        ProofResult result = new MassRatiosProof(1).run(unit, 1, Proof.Progress.NONE);
        assertEquals(0, result.failures(), () -> String.join("\n", result.examples()));
    }
}
