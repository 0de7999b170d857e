package nephele.app.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import nephele.app.Main;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class EditProcessesTest {
    @Test
    void itStartsThisJavaWithTheseClasses() {
        var words = EditCommand.waitingGame(Path.of("levels", "01-courtyard.json"));
        assertTrue(Files.isExecutable(Path.of(words.get(0))), words.get(0));
        assertTrue(words.contains(System.getProperty("java.class.path")));
        assertEquals(words.indexOf("play"), words.indexOf(Main.class.getName()) + 1);
        assertEquals("--warm", words.get(words.indexOf("play") + 1));
        assertTrue(words.get(words.size() - 1).endsWith("01-courtyard.json"));
    }

    @Test
    void aLevelThatIsNotSavedIsNotNamed() {
        assertEquals(EditCommand.waitingGame(null), EditCommand.waitingGame(Path.of("levels", "none.json")));
    }
}
