package nephele.workshop.prove.portals;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;

/** The proof {@code doorway-walk} holds with small pictures. */
class DoorwayWalkProofGlTest {
    private static ProofResult walks(long from, long count) {
        return new DoorwayWalkProof(160, 90).run(from, count, Proof.Progress.NONE);
    }

    @Test
    void theEyeSeesADoorway() {
        assertEquals(List.of(), walks(0, 3).examples());
    }

    @Test
    void theBoomSeesADoorway() {
        assertEquals(List.of(), walks(6, 1).examples());
    }

    @Test
    void aCubeInHandGoesThroughADoorway() {
        var result = walks(9, 1);
        assertEquals(List.of(), result.examples());
        assertTrue(result.figures().stream().anyMatch(figure -> figure.name().equals("frames") && figure.value() > 60));
    }

    /** A pop would be detected: one white row of 54 in a black picture. */
    @Test
    void aPopWouldBeMeasured() {
        byte[] black = new byte[4 * 96 * 54];
        byte[] row = black.clone();
        java.util.Arrays.fill(row, 0, 4 * 96, (byte) 255);
        var step = FrameSteps.between(black, row);
        assertEquals(255.0 / 54, step.mean(), 1e-9);
        assertEquals(255, step.most());
    }
}
