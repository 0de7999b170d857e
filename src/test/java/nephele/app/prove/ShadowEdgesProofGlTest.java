package nephele.app.prove;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

/** The same code as `prove shadow-edges`, for a few pictures under sun and lamp. */
class ShadowEdgesProofGlTest {
    @Test
    void shadowsEndWithinATexelOfWhereRaysSay() {
        var result = new ShadowEdgesProof()
                .run(2, 2, Proof.Progress.NONE)
                .and(new ShadowEdgesProof().run(18, 1, Proof.Progress.NONE));
        assertEquals(3, result.units());
        assertEquals(List.of(), result.examples());
        assertTrue(result.figures().get(1).value() > 10, "edges are in these pictures, and pixels beside them differ");
    }
}
