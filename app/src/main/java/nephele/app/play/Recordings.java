package nephele.app.play;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import nephele.app.terminal.CommandFailure;
import nephele.engine.sim.Replay;

/** Replays on disk. */
final class Recordings {
    private Recordings() {}

    static void write(Path file, Replay replay) {
        try {
            var folder = file.toAbsolutePath().getParent();
            if (folder != null) {
                Files.createDirectories(folder);
            }
            Files.writeString(file, replay.write());
        } catch (IOException failure) {
            throw CommandFailure.environment(
                    file + ": the recording can't be written ("
                            + failure.getClass().getSimpleName() + ")",
                    failure);
        }
    }
}
