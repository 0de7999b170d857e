package nephele.app.play;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.LinkedBlockingDeque;
import nephele.editor.play.PlayOrder;
import nephele.engine.level.json.LevelFormatException;

/** The orders of the process that started this one, read on a thread of its own. The end of the input is {@link Leave}. */
final class OrderQueue {
    private static final int MOST_WAITING = 8;

    private final LinkedBlockingDeque<Entry> waiting = new LinkedBlockingDeque<>(MOST_WAITING);
    private final Reader input;

    /** A line of the input, parsed. */
    sealed interface Entry {}

    /**
     * A level to play or to prepare.
     *
     * @param nanos when it was read, by {@link System#nanoTime}
     */
    record Ordered(PlayOrder order, long nanos) implements Entry {}

    /** A line that is no order. */
    record Rejected(String message) implements Entry {}

    /** The process shall end. */
    record Leave() implements Entry {}

    private OrderQueue(InputStream in) {
        input = new InputStreamReader(in, StandardCharsets.UTF_8);
    }

    /**
     * Starts to read.
     *
     * @param afterEnd runs on the reading thread after the last line
     */
    static OrderQueue reading(InputStream in, Runnable afterEnd) {
        var queue = new OrderQueue(in);
        var thread = new Thread(
                () -> {
                    queue.readAll();
                    afterEnd.run();
                },
                "orders");
        thread.setDaemon(true);
        thread.start();
        return queue;
    }

    /** Waits for the next entry and removes it. */
    Entry take() {
        try {
            return waiting.take();
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            return new Leave();
        }
    }

    /** Returns true if the current play is to end for the next entry. */
    boolean isAnyWaiting() {
        return !waiting.isEmpty();
    }

    private void readAll() {
        try {
            for (String line = nextLine(); line != null; line = nextLine()) {
                if (line.equals("quit")) {
                    break;
                }
                add(entry(line));
            }
        } catch (IOException closed) {
            add(new Leave());
        }
        add(new Leave());
    }

    /** Adds an entry; when too many wait, the oldest is replaced by what came after it. */
    private void add(Entry entry) {
        while (!waiting.offerLast(entry)) {
            waiting.pollFirst();
        }
    }

    private static Entry entry(String line) {
        try {
            return new Ordered(PlayOrder.read(line), System.nanoTime());
        } catch (LevelFormatException wrong) {
            return new Rejected(wrong.getMessage());
        }
    }

    /** Returns the next line, {@code null} at the end; of a line that is too long only its beginning. */
    private String nextLine() throws IOException {
        var line = new StringBuilder();
        int character = input.read();
        if (character < 0) {
            return null;
        }
        for (; character >= 0 && character != '\n'; character = input.read()) {
            if (line.length() <= PlayOrder.MOST_CHARACTERS && character != '\r') {
                line.append((char) character);
            }
        }
        return line.toString();
    }
}
