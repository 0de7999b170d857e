package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import nephele.engine.sim.replay.Replay;
import nephele.host.terminal.CommandFailure;
import nephele.host.terminal.ExitCode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RecordingsTest {
    @TempDir
    Path folder;

    private static Replay walk(int ticks) {
        return Replay.standing("level.json", ticks);
    }

    @Test
    void everyRecordingKeepsItsOwnFile() throws Exception {
        var recordings = new Recordings(folder.resolve("walk.json"));
        for (int i = 1; i <= 3; i++) {
            var name = i == 1 ? "walk.json" : "walk-" + i + ".json";
            int length = i;
            assertEquals(Optional.of(folder.resolve(name)), recordings.keep(() -> walk(length)));
        }
        for (int i = 1; i <= 3; i++) {
            var name = i == 1 ? "walk.json" : "walk-" + i + ".json";
            assertEquals(
                    i,
                    Replay.read(name, Files.readAllBytes(folder.resolve(name))).ticks());
        }
    }

    @Test
    void withoutAFileNothingIsKept() {
        assertEquals(Optional.empty(), new Recordings(null).keep(() -> walk(1)));
    }

    @Test
    void aFileThatCannotBeWrittenIsNamed() {
        var failure = assertThrows(CommandFailure.class, () -> new Recordings(folder).keep(() -> walk(1)));
        assertEquals(ExitCode.ENVIRONMENT, failure.exitCode());
        assertTrue(failure.getMessage().startsWith(folder + ": can't be written: it is a folder"));
    }
}
