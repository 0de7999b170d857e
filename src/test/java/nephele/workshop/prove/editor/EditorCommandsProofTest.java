package nephele.workshop.prove.editor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Random commands undone and redone; {@code prove editor-commands} has ten thousand. */
@Execution(ExecutionMode.CONCURRENT)
class EditorCommandsProofTest {
    @Test
    void undoingAndRedoingEverythingGivesTheSameTexts() throws Exception {
        ProofResult result = new EditorCommandsProof().run(0, 150, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertTrue(result.value("steps undone and redone") > 60, result.toString());
    }
}
