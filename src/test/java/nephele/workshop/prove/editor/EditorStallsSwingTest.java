package nephele.workshop.prove.editor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** One level with a sky, its air and a cloud; {@code prove editor-stalls} has the dear ones. */
@Execution(ExecutionMode.SAME_THREAD)
class EditorStallsSwingTest {
    @Test
    void theWindowsThreadAnswersWhileALevelIsDrawn() throws Exception {
        ProofResult result = new EditorStallsProof().run(0, 1, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertTrue(result.value("longest picture meanwhile") > 0, result.toString());
    }
}
