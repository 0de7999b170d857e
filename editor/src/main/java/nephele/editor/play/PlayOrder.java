package nephele.editor.play;

import java.util.List;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.Problem;
import nephele.engine.level.TextKind;
import nephele.engine.level.Written;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.RecordFile;

/**
 * A request to the waiting game, one line of its input.
 *
 * @param level the level's own file, for its assets and its name; it need not exist
 * @param snapshot the file of the state to play
 * @param from where the player starts, {@code null} for the level's start
 * @param quality the quality preset, {@code null} for that of the player's settings
 * @param record the file in which a solution is recorded, {@code null} for none
 */
public record PlayOrder(
        @Written(required = true, text = TextKind.PROSE) String level,
        @Written(required = true, text = TextKind.PROSE) String snapshot,
        @Written PlayerStart from,
        @Written String quality,
        @Written(text = TextKind.PROSE) String record) {
    /** The greatest length of a line in characters. */
    public static final int MOST_CHARACTERS = 1 << 16;

    private static final String WORD = "play ";

    /** The name of an order in messages. */
    private static final String NAME = "order";

    private static final RecordFile<PlayOrder> FILE = RecordFile.of("play-order", 1, PlayOrder.class);

    /**
     * Reads a line.
     *
     * @throws LevelFormatException with all problems found
     */
    public static PlayOrder read(String line) {
        if (line.length() > MOST_CHARACTERS) {
            throw wrong("is longer than " + MOST_CHARACTERS + " characters");
        }
        if (!line.startsWith(WORD)) {
            throw wrong("a line is `play {...}` or `quit`");
        }
        return FILE.read(NAME, PlayAnswer.utf8(line.substring(WORD.length())));
    }

    private static LevelFormatException wrong(String message) {
        return new LevelFormatException(NAME, List.of(Problem.error("$", message)));
    }

    /** Returns the line, without a line feed. */
    public String line() {
        return WORD + PlayAnswer.oneLine(FILE.write(this));
    }
}
