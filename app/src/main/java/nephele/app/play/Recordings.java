package nephele.app.play;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Supplier;
import nephele.engine.asset.AtomicFile;
import nephele.engine.sim.replay.Replay;
import nephele.host.terminal.CommandFailure;

/**
 * The replay files of one game. Every level played and every restart is a separate recording: the first is saved in the
 * requested file, {@code walk.json}, the next ones in {@code walk-2.json}, {@code walk-3.json} and so on.
 */
final class Recordings {
    private final Path file;
    private int kept;

    /** @param file null if nothing is recorded */
    Recordings(Path file) {
        this.file = file;
    }

    /** Makes and writes the recording if one was requested. Returns its file. */
    Optional<Path> keep(Supplier<Replay> recording) {
        if (file == null) {
            return Optional.empty();
        }
        var replay = recording.get();
        var next = kept == 0 ? file : numbered(kept + 1);
        try {
            AtomicFile.write(next, replay.write().getBytes(StandardCharsets.UTF_8));
        } catch (IOException failure) {
            throw CommandFailure.environment(failure.getMessage(), failure);
        }
        kept++;
        return Optional.of(next);
    }

    private Path numbered(int number) {
        var name = file.getFileName().toString();
        int dot = name.lastIndexOf('.') > 0 ? name.lastIndexOf('.') : name.length();
        return file.resolveSibling(name.substring(0, dot) + "-" + number + name.substring(dot));
    }
}
