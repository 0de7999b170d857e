package nephele.app.command;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import nephele.app.terminal.CommandFailure;

/** Files that a user asked for; their folder is made when it is missing. */
final class WrittenFile {
    private WrittenFile() {}

    /** Writes into a file whose folder exists by then. */
    @FunctionalInterface
    interface Writer {
        void write(Path file) throws IOException;
    }

    static void text(Path file, String content) {
        write(file, to -> Files.writeString(to, content));
    }

    /** A failure names the file and why (exit code 3). */
    static void write(Path file, Writer writer) {
        try {
            var folder = file.toAbsolutePath().getParent();
            if (folder != null) {
                Files.createDirectories(folder);
            }
            writer.write(file);
        } catch (IOException failure) {
            throw CommandFailure.environment(file + ": can't be written: " + reason(failure), failure);
        }
    }

    private static String reason(IOException failure) {
        boolean named = failure instanceof FileSystemException;
        var reason = named ? ((FileSystemException) failure).getReason() : failure.getMessage();
        return reason == null ? failure.getClass().getSimpleName() : reason;
    }
}
