package nephele.app.command;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import nephele.engine.asset.WholeFile;
import nephele.engine.terminal.CommandFailure;

/** Files that a user asked for; their folder is made when it is missing. */
final class WrittenFile {
    private WrittenFile() {}

    /** Writes a file in one step; its failures name the file and why. */
    @FunctionalInterface
    interface Writer {
        void write(Path file) throws IOException;
    }

    static void text(Path file, String content) {
        write(file, to -> WholeFile.write(to, content.getBytes(StandardCharsets.UTF_8)));
    }

    /** A failure is the environment's (exit code 3). */
    static void write(Path file, Writer writer) {
        try {
            writer.write(file);
        } catch (IOException failure) {
            throw CommandFailure.environment(failure.getMessage(), failure);
        }
    }
}
