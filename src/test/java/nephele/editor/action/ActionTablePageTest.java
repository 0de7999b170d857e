package nephele.editor.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class ActionTablePageTest {
    @Test
    void thePageIsCurrent() throws IOException {
        assertEquals(
                ActionTablePage.text(),
                Files.readString(Path.of("docs", "editor-keys.md")),
                "run ./gradlew editorKeys");
    }

    @Test
    void noTwoActionsHaveOneNameOrOneKey() {
        Set<String> seen = new HashSet<>();
        for (EditorAction action : Actions.ALL) {
            assertTrue(seen.add(action.id()), action.id());
            action.keys().forEach(key -> assertTrue(seen.add("key " + key), action.id() + " shares " + key));
        }
    }
}
