package nephele.editor.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.level.PlayerStart;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** How a play ended is told by what it was for. */
class PlayTextTest {
    private static final PlayerStart HERE = new PlayerStart(Vec3.ZERO, 0, 0);

    @Test
    void aRecordingThatWasLeftBeforeTheExitSaysThatNothingWasRecorded() {
        PlayEnd left = new PlayEnd(HERE, false, 0, 0, null);
        assertTrue(PlayText.ofRecording(left).english().contains("No solution was recorded"));
        assertEquals(PlayText.ENDED.words(), PlayText.of(left));
        PlayEnd solved = new PlayEnd(HERE, true, 9, 2, "room.replay");
        assertTrue(PlayText.ofRecording(solved).english().contains("room.replay"));
    }
}
