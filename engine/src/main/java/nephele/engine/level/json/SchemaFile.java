package nephele.engine.level.json;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Writes {@code docs/level.schema.json}; a test fails if the file is out of date. */
final class SchemaFile {
    private SchemaFile() {}

    /** @param arguments the file to write */
    public static void main(String[] arguments) throws IOException {
        Files.writeString(Path.of(arguments[0]), LevelJson.schema());
    }
}
