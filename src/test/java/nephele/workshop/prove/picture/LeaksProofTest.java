package nephele.workshop.prove.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.workshop.prove.proof.Proof;
import org.junit.jupiter.api.Test;

/** The proof {@code leaks} holds for a few rooms. */
class LeaksProofTest {
    @Test
    void noLightPassesWallsAndNoTexelIsDarkBesideAnotherChart() {
        var result = new LeaksProof().run(0, 3, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertTrue(result.value("texels beside another chart") > 100, result.figures()::toString);
    }
}
