package nephele.workshop.prove.editor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** A short session of random input; {@code prove editor-events} has a hundred long ones. */
@Execution(ExecutionMode.SAME_THREAD)
class EditorEventsSwingTest {
    @Test
    void noInputBreaksTheEditor() throws Exception {
        ProofResult result = new EditorEventsProof().run(0, 200, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertTrue(result.value("pictures drawn") > 30, result.toString());
    }
}
