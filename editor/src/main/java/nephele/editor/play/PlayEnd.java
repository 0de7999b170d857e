package nephele.editor.play;

import nephele.engine.level.PlayerStart;
import nephele.engine.level.Range;
import nephele.engine.level.TextKind;
import nephele.engine.level.Written;
import nephele.engine.level.json.RecordFile;

/**
 * The end of a play from the editor.
 *
 * @param player where the player stood and looked at last
 * @param exitReached true if the player entered an exit
 * @param exitSeconds the simulated time of that since the start; 0 if no exit was reached
 * @param portals the number of portals shot until then
 * @param recorded the file of the recorded solution, {@code null} if none was kept
 */
public record PlayEnd(
        @Written(required = true) PlayerStart player,
        @Written boolean exitReached,
        @Written @Range(min = 0) double exitSeconds,
        @Written @Range(min = 0) int portals,
        @Written(text = TextKind.PROSE) String recorded) {
    private static final RecordFile<PlayEnd> FILE = RecordFile.of("play-end", 1, PlayEnd.class);

    static PlayEnd read(String line) {
        return FILE.read("ended", PlayAnswer.utf8(line));
    }

    String line() {
        return PlayAnswer.oneLine(FILE.write(this));
    }
}
