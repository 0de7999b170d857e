package nephele.engine.level;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import nephele.engine.level.json.LevelJson;
import org.junit.jupiter.api.Test;

class LevelSchemaTest {
    @Test
    void theSchemaInDocsIsThatOfTheRecords() throws IOException {
        assertEquals(
                LevelJson.schema(),
                Files.readString(Path.of("docs/level.schema.json")),
                "the records have changed: run gradle :engine:levelSchema");
    }
}
