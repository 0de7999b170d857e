package nephele.editor.play;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import nephele.engine.level.json.LevelFormatException;

/** A line that the waiting game writes: a word, then what belongs to it. */
public sealed interface PlayAnswer {
    /** Returns the line, without a line feed. */
    String line();

    /** The game waits for an order. */
    record Ready() implements PlayAnswer {
        @Override
        public String line() {
            return "ready";
        }
    }

    /**
     * The first frame is on the screen.
     *
     * @param millis since the order was read
     */
    record Playing(long millis) implements PlayAnswer {
        @Override
        public String line() {
            return "playing " + millis;
        }
    }

    /** The level's light is being baked while it is played; 100 when it is shown. */
    record Baking(int percent) implements PlayAnswer {
        @Override
        public String line() {
            return "baking " + percent;
        }
    }

    /** The player has left, or the play was replaced by the next one. */
    record Ended(PlayEnd end) implements PlayAnswer {
        @Override
        public String line() {
            return "ended " + end.line();
        }
    }

    /** The order could not be carried out, or its recording not be written; the message says why. */
    record Failed(String message) implements PlayAnswer {
        @Override
        public String line() {
            return "failed " + oneLine(message);
        }
    }

    /** Reads a line; empty for one that is no answer, such as a library's message. */
    static Optional<PlayAnswer> read(String line) {
        int space = line.indexOf(' ');
        String word = space < 0 ? line : line.substring(0, space);
        String rest = space < 0 ? "" : line.substring(space + 1);
        try {
            return switch (word) {
                case "ready" -> Optional.of(new Ready());
                case "playing" -> Optional.of(new Playing(Long.parseLong(rest)));
                case "baking" -> Optional.of(new Baking(Integer.parseInt(rest)));
                case "ended" -> Optional.of(new Ended(PlayEnd.read(rest)));
                case "failed" -> Optional.of(new Failed(rest));
                default -> Optional.empty();
            };
        } catch (NumberFormatException | LevelFormatException damaged) {
            return Optional.empty();
        }
    }

    /** Returns a JSON text as a single line: its line feeds are all between tokens. */
    static String oneLine(String json) {
        return json.replaceAll("\\s*\\n\\s*", " ").strip();
    }

    static byte[] utf8(String line) {
        return line.getBytes(StandardCharsets.UTF_8);
    }
}
