package nephele.editor.play;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalLong;
import java.util.function.Consumer;
import java.util.function.Supplier;
import nephele.engine.asset.AtomicFile;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelJson;

/**
 * The game in a process of its own, started before it is needed, for play from the editor. It plays a snapshot of the
 * level, so that unsaved edits are played. When the process dies the next one is started; it never outlives this one,
 * because it ends with its input. Thread-safe; the listener is called on threads of its own.
 */
public final class WarmGame implements AutoCloseable {
    /**
     * Options of the Java virtual machine by which the waiting game keeps little memory: a small young generation, as a frame allocates next to nothing, and a heap
     * that is given back after a play, as is what the C library has freed (Java 17.0.9 and later). The first of the two compilers is enough for a game whose first seconds count:
     * with both, the first frame of level 01 costs 2.6 s of processor time instead of 1.7 s, and 20 MB more.
     */
    public static final List<String> JAVA_OPTIONS = List.of(
            "-XX:+UseSerialGC",
            "-Xms16m",
            "-Xmn8m",
            "-XX:MinHeapFreeRatio=5",
            "-XX:MaxHeapFreeRatio=10",
            "-XX:-ShrinkHeapInSteps",
            "-XX:TieredStopAtLevel=1",
            "-XX:+IgnoreUnrecognizedVMOptions",
            "-XX:TrimNativeHeapInterval=3000");

    private final Supplier<List<String>> commandLine;
    private final Consumer<PlayAnswer> listener;
    private GameProcess process;
    private Path snapshot;
    private boolean isClosed;

    /**
     * A play to start.
     *
     * @param level as edited, saved or not
     * @param file the level's own file, for its name and its assets; it need not exist
     * @param from where the player starts, {@code null} for the level's start
     * @param quality the quality preset, {@code null} for that of the player's settings
     * @param record the file for a solution, {@code null} for none: see {@link SolutionCheck#fileOf}
     */
    public record Request(Level level, Path file, PlayerStart from, String quality, Path record) {}

    /**
     * @param commandLine the game's program and its arguments, which make it wait for orders
     * @param listener receives what happens to the game; {@link PlayAnswer.Playing} counts from the call of {@link #play},
     *     {@link PlayAnswer.Failed} also reports that a play did not begin or that the process broke off
     */
    public WarmGame(Supplier<List<String>> commandLine, Consumer<PlayAnswer> listener) {
        this.commandLine = commandLine;
        this.listener = listener;
    }

    /** Starts the process in the background if none runs. */
    public synchronized void warm() {
        if (!isClosed && (process == null || !process.isAlive())) {
            try {
                process = GameProcess.start(commandLine.get(), this::answered, this::died);
            } catch (IOException missing) {
                process = null;
                listener.accept(new PlayAnswer.Failed("the game can't be started: " + missing.getMessage()));
            }
        }
    }

    /** Returns true if a process waits or plays. */
    public synchronized boolean isReady() {
        return process != null && process.isReady();
    }

    /** Returns the id of the process; empty if none runs. */
    public synchronized OptionalLong processId() {
        return process == null || !process.isAlive() ? OptionalLong.empty() : OptionalLong.of(process.id());
    }

    /** Plays a level as soon as possible; a present play ends for it. Starts the process if none runs. */
    public synchronized void play(Request request) {
        if (isClosed) {
            return;
        }
        long now = System.nanoTime();
        try {
            var order = new PlayOrder(
                    request.file().toAbsolutePath().toString(),
                    kept(request.level()).toString(),
                    request.from(),
                    request.quality(),
                    request.record() == null
                            ? null
                            : request.record().toAbsolutePath().toString());
            warm();
            if (process != null) {
                process.order(order, now);
            }
        } catch (IOException | LevelFormatException unwritten) {
            listener.accept(new PlayAnswer.Failed("the level can't be played: " + unwritten.getMessage()));
        }
    }

    /** Writes the snapshot. A file that the game is reading still is replaced by another one, not changed. */
    private Path kept(Level level) throws IOException {
        byte[] text = LevelJson.write(level).getBytes(StandardCharsets.UTF_8);
        Path next = Files.createTempFile("nephele-play-", ".json");
        AtomicFile.write(next, text);
        deleteSnapshot();
        snapshot = next;
        return next;
    }

    private void deleteSnapshot() {
        try {
            if (snapshot != null) {
                Files.deleteIfExists(snapshot);
            }
        } catch (IOException leftToTheSystem) {
            snapshot.toFile().deleteOnExit(); // on Windows the game may be reading it
        }
        snapshot = null;
    }

    private void answered(PlayAnswer answer, long orderedNanos) {
        listener.accept(
                answer instanceof PlayAnswer.Playing
                        ? new PlayAnswer.Playing((System.nanoTime() - orderedNanos) / 1_000_000)
                        : answer);
    }

    /** Starts the next process, unless the last one never became ready: that would go on for ever. */
    private void died(GameProcess dead, String message) {
        boolean wasReady = dead.isReady();
        synchronized (this) {
            if (isClosed || dead != process) {
                return;
            }
            process = null;
        }
        listener.accept(new PlayAnswer.Failed(message));
        if (wasReady) {
            warm();
        }
    }

    /** Ends the process; a play ends with it. */
    @Override
    public synchronized void close() {
        isClosed = true;
        if (process != null) {
            process.close();
        }
        deleteSnapshot();
    }
}
