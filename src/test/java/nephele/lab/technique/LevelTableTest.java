package nephele.lab.technique;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import nephele.engine.choice.ErrorTable;
import nephele.engine.choice.ErrorTable.Row;
import nephele.engine.level.CloudTechnique;
import nephele.host.terminal.CommandFailure;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LevelTableTest {
    @TempDir
    Path folder;

    private static ErrorTable table(String form, double error) {
        return new ErrorTable(List.of(new Row(form, CloudTechnique.VOLUME, 4, 10, 30, error, 2)));
    }

    @Test
    void rowsOfOtherCloudsStayAndItsOwnAreReplaced() throws IOException {
        Path file = folder.resolve(ErrorTable.FILE);
        LevelTable.write(file, table("cloud a", 1));
        LevelTable.write(file, table("cloud b", 2));
        LevelTable.write(file, table("cloud a", 3));
        assertEquals(
                List.of(ErrorTable.HEADER, "cloud b,volume,4,10,30,2.00,2.000", "cloud a,volume,4,10,30,3.00,2.000"),
                Files.readAllLines(file));
    }

    @Test
    void aBrokenFileIsNamedAndStays() throws IOException {
        Path file = folder.resolve(ErrorTable.FILE);
        Files.writeString(file, ErrorTable.HEADER + "\nnonsense\n");
        var failure = assertThrows(CommandFailure.class, () -> LevelTable.write(file, table("cloud a", 1)));
        assertTrue(
                failure.getMessage().startsWith(file + ": line 2")
                        && failure.getMessage().endsWith("delete the file"),
                failure.getMessage());
        assertTrue(Files.readString(file).contains("nonsense"));
    }

    @Test
    void aLevelWithoutAFolderIsToldBeforeAnythingIsMeasured() {
        var failure = assertThrows(CommandFailure.class, () -> new LevelTable(null, "levels/none.json", 1, System.err));
        assertTrue(failure.getMessage().startsWith("levels/none.json: "), failure.getMessage());
    }
}
