package nephele.engine.level.json;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Writes {@code docs/level.schema.json} anew; a test tells when that is due. */
final class SchemaFile {
    private SchemaFile() {}

    /** @param arguments the file to write */
    public static void main(String[] arguments) throws IOException {
        Files.writeString(Path.of(arguments[0]), LevelJson.schema());
    }
}
