package nephele.workshop.prove.editor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Two looks of the editor, few of them painted; {@code prove editor-pictures} paints all. */
@Execution(ExecutionMode.SAME_THREAD)
class EditorPicturesSwingTest {
    @Test
    void noTextIsCutOff() throws Exception {
        ProofResult result = new EditorPicturesProof(20).run(1, 2, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertTrue(result.value("pictures searched") > 80, result.toString());
    }
}
