package nephele.workshop.prove.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;

/** The proof holds for a few cameras on a smaller terrain, and fails where less is drawn. */
class TerrainDetailProofTest {
    @Test
    void noSampleIsDrawnMoreThanAPixelFromItsPlace() {
        ProofResult result = new TerrainDetailProof(513).run(0, 12, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertTrue(result.value("samples compared") > 100_000, "samples are in the pictures");
        assertTrue(result.value("greatest error") > 0.3, "coarser triangles are used");
    }
}
