package nephele.app.command;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.util.List;
import nephele.host.terminal.ExitCode;
import org.junit.jupiter.api.Test;

class ExplanationTest {
    private static void isEnvironment(String message, IOException failure) {
        var explained = Explanation.of(failure, List.of("play"));
        assertEquals(ExitCode.ENVIRONMENT, explained.exitCode());
        assertEquals(message, explained.message());
    }

    @Test
    void aFileThatCannotBeWrittenIsNoBug() {
        isEnvironment("build/x: access is denied", new AccessDeniedException("build/x"));
        isEnvironment(
                "build/x: the disk is full; make room on it, or choose another place",
                new FileSystemException("build/x", null, "No space left on device"));
        isEnvironment(
                "a.png: can't be written: it is a folder", new IOException("a.png: can't be written: it is a folder"));
        var wrapped = new UncheckedIOException(new AccessDeniedException("build/x"));
        assertEquals(
                "build/x: access is denied",
                Explanation.of(wrapped, List.of("trade")).message());
    }
}
