package nephele.workshop.prove.edits;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;

/** The proof {@code edits} holds for a smaller town and fewer edits. */
class EditsProofGlTest {
    @Test
    void anEditedTownIsDrawnAsAFreshOne() {
        ProofResult result =
                new EditsProof("edits", "", 2, 1, EditedTownTest::bakedInPart).run(0, 20, Proof.Progress.NONE);
        assertEquals(20, result.units());
        assertEquals(List.of(), result.examples());
    }

    @Test
    void slowEditsRefuteTheClaimOfAllOfThem() {
        ProofResult slow = ProofResult.of(1_000, List.of(), Figure.greatest("median of an edit", 17, "ms"));
        assertTrue(ProofResult.of(1_000, List.of()).holds());
        assertFalse(new EditsProof("edits", "", 1, 1, EditedTown::baked)
                .judged(slow)
                .holds());
    }
}
