package nephele.workshop.prove.cloud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.render.gl.GlContext;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;

/** The proof {@code cloud-volume} holds for two of its clouds, drawn in the size of the traced picture. */
class CloudVolumeProofGlTest {
    @Test
    void drawnCloudsAreAsBrightAsTracedOnes() {
        ProofResult result = ProofResult.NOTHING;
        try (GlContext gl = GlContext.offscreen()) {
            for (String name : List.of("low-sun", "inside")) {
                result = result.and(CloudVolumeProof.compared(gl, ReferenceCase.named(name), 1, 0));
            }
        }
        assertEquals(List.of(), result.examples());
        assertTrue(result.value("low-sun, octaves, mean off") < -20, "the light of octaves is another: " + result);
    }
}
