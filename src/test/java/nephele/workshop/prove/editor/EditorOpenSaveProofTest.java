package nephele.workshop.prove.editor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Opening and saving keeps the files of levels; {@code prove editor-open-save} has all of them. */
@Execution(ExecutionMode.CONCURRENT)
class EditorOpenSaveProofTest {
    @Test
    void onlyWhatIsEditedChanges() throws Exception {
        ProofResult result = new EditorOpenSaveProof().run(0, 8, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertTrue(result.value("edits") > 8, result.toString());
    }
}
