package nephele.editor.play;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.ObjLongConsumer;

/** A process of the waiting game and the threads that read its output. */
final class GameProcess implements AutoCloseable {
    private static final int MOST_COMPLAINTS = 8;
    private static final int LONGEST_COMPLAINT = 300;
    private static final long LONGEST_END_SECONDS = 6;

    private final Process process;
    private final Writer orders;
    private final Deque<String> complaints = new ArrayDeque<>();
    private volatile boolean isReady;
    private volatile long orderedNanos;
    private Thread complaining;

    private GameProcess(Process process) {
        this.process = process;
        orders = new OutputStreamWriter(process.getOutputStream(), StandardCharsets.UTF_8);
    }

    /**
     * @param answered receives each answer, and when its order was given
     * @param died receives the process and a message for the user after its end
     */
    static GameProcess start(
            List<String> command, ObjLongConsumer<PlayAnswer> answered, BiConsumer<GameProcess, String> died)
            throws IOException {
        var builder = new ProcessBuilder(command);
        limitMemory(builder.environment());
        var started = new GameProcess(builder.start());
        started.complaining = thread("game complaints", started::readComplaints);
        thread("game answers", () -> {
            started.readAnswers(answered);
            died.accept(started, started.lastWords());
        });
        return started;
    }

    private static Thread thread(String name, Runnable work) {
        var thread = new Thread(work, name);
        thread.setDaemon(true);
        thread.start();
        return thread;
    }

    boolean isAlive() {
        return process.isAlive();
    }

    /** Returns true once it has been ready. */
    boolean isReady() {
        return isReady;
    }

    long id() {
        return process.pid();
    }

    /**
     * Sends an order; a process that is not ready yet reads it later.
     *
     * @param nanos when the user gave it
     */
    void order(PlayOrder order, long nanos) {
        orderedNanos = nanos;
        try {
            orders.write(order.line() + "\n");
            orders.flush();
        } catch (IOException dying) {
            process.destroy(); // the thread that reads its answers reports the failure
        }
    }

    private void readAnswers(ObjLongConsumer<PlayAnswer> answered) {
        eachLine(process.getInputStream(), line -> PlayAnswer.read(line).ifPresent(answer -> {
            isReady |= answer instanceof PlayAnswer.Ready;
            answered.accept(answer, orderedNanos);
        }));
    }

    private void readComplaints() {
        eachLine(process.getErrorStream(), line -> {
            synchronized (complaints) {
                complaints.addLast(line.substring(0, Math.min(LONGEST_COMPLAINT, line.length())));
                if (complaints.size() > MOST_COMPLAINTS) {
                    complaints.removeFirst();
                }
            }
        });
    }

    private static void eachLine(InputStream in, Consumer<String> use) {
        try (var reader = new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8))) {
            for (String line = reader.readLine(); line != null; line = reader.readLine()) {
                use.accept(line);
            }
        } catch (IOException closed) {
            return;
        }
    }

    /** Returns why the process ended, as far as it printed that. */
    private String lastWords() {
        try {
            int code = process.waitFor();
            complaining.join(TimeUnit.SECONDS.toMillis(LONGEST_END_SECONDS));
            synchronized (complaints) {
                String reason = complaints.isEmpty() ? "it gave no reason" : String.join(" / ", complaints);
                return "the game ended (exit code " + code + "): " + reason;
            }
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            return "the game ended";
        }
    }

    /** Closes its input, which ends it, and ends it by force if that takes too long. */
    @Override
    public void close() {
        try {
            orders.close();
        } catch (IOException ended) {
            process.destroy();
        }
        process.onExit()
                .orTimeout(LONGEST_END_SECONDS, TimeUnit.SECONDS)
                .exceptionally(late -> process.destroyForcibly());
    }

    /** Sets what the C library keeps: few arenas for llvmpipe's many threads, and freed pictures return to the system. */
    private static void limitMemory(Map<String, String> environment) {
        environment.putIfAbsent("MALLOC_ARENA_MAX", "2");
        environment.putIfAbsent("MALLOC_TRIM_THRESHOLD_", "131072");
        environment.putIfAbsent("MALLOC_MMAP_THRESHOLD_", "131072");
    }
}
