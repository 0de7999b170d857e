package nephele.app.command;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import nephele.engine.asset.AtomicFile;
import nephele.engine.reference.tile.PartFileException;
import nephele.host.terminal.CommandFailure;

/** Writes the files that a user requested; a missing folder is made. */
final class WrittenFile {
    private WrittenFile() {}

    /** Writes a file atomically; its failures name the file and the reason. */
    @FunctionalInterface
    interface Writer {
        void write(Path file) throws IOException;
    }

    static void text(Path file, String content) {
        write(file, to -> AtomicFile.write(to, content.getBytes(StandardCharsets.UTF_8)));
    }

    /** Writes a file; a failure is reported as one of the environment (exit code 3). */
    static void write(Path file, Writer writer) {
        try {
            writer.write(file);
        } catch (IOException failure) {
            throw CommandFailure.environment(failure.getMessage(), failure);
        }
    }

    /** Work on the part files of a traced picture. */
    @FunctionalInterface
    interface PartWork<T> {
        T run() throws IOException;
    }

    /** Returns the result of work on part files, whose failures name the file and the reason. */
    static <T> T ofParts(PartWork<T> work) {
        try {
            return work.run();
        } catch (PartFileException unusable) {
            throw CommandFailure.input(unusable.getMessage());
        } catch (FileSystemException failure) {
            throw CommandFailure.environment(
                    failure.getFile() + ": can't be used: " + AtomicFile.reason(failure), failure);
        } catch (IOException failure) {
            throw CommandFailure.environment(
                    failure.getMessage() == null ? AtomicFile.reason(failure) : failure.getMessage(), failure);
        }
    }
}
