package nephele.workshop.prove.bodies;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;

/** Falls between two arches in the floor, one rotated by a quarter turn, keep their height, at a reduced count. */
final class FallsProofTest {
    @Test
    void everyFallComesUpAgain() {
        for (int rate = 0; rate < 4; rate++) {
            ProofResult result = new FallsProof().run(rate * 10_000, 100, Proof.Progress.NONE);
            assertEquals(List.of(), result.examples());
            assertEquals(0, result.failures());
        }
    }
}
