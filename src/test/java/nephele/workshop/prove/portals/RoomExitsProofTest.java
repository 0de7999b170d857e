package nephele.workshop.prove.portals;

import static org.junit.jupiter.api.Assertions.assertEquals;

import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The proof holds at a reduced count, a few exits in each of some rooms. */
@Execution(ExecutionMode.CONCURRENT)
final class RoomExitsProofTest {
    @Test
    void nobodyEndsInACornerThatWalkingDoesNotLeave() {
        for (int room = 0; room < 5; room++) {
            ProofResult result = new RoomExitsProof().run(100 * room, 5, Proof.Progress.NONE);
            assertEquals(0, result.failures(), () -> String.join("\n", result.examples()));
            assertEquals(0, result.value("units without a crossing"));
        }
    }
}
