package nephele.workshop.prove.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;

/** The proof {@code scene-culling} holds for 250 of its 10⁴ models. */
class SceneCullingProofGlTest {
    @Test
    void picturesWithCullingAreThoseWithout() {
        var result = new SceneCullingProof().run(0, 10, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertEquals(250, value(result, "models"));
        assertTrue(value(result, "pixels that show something") > 20_000, "models are in the pictures");
        double share = value(result, "triangles culled") / value(result, "triangles");
        assertTrue(share > 0.3 && share < 0.95, "culled share " + share);
    }

    private static double value(ProofResult result, String name) {
        return result.figure(name).orElseThrow().value();
    }
}
