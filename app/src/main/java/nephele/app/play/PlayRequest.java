package nephele.app.play;

import java.nio.file.Path;
import nephele.engine.draw.QualityChoice;
import nephele.engine.level.PlayerStart;
import nephele.engine.named.LevelName;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.SimSettings;

/**
 * The options of a game.
 *
 * @param from null for the level's start
 * @param replay null for keyboard and mouse
 * @param record null if nothing is recorded
 */
public record PlayRequest(
        LevelName level,
        PlayerStart from,
        QualityChoice quality,
        Replay replay,
        Path record,
        SimSettings simulation,
        Picture picture) {
    /** The picture's size in pixels, and true for full screen. */
    public record Picture(int width, int height, boolean fullScreen) {}

    PlayRequest with(SimSettings changed) {
        return new PlayRequest(level, from, quality, replay, record, changed, picture);
    }

    /** Returns in words when settings take effect that are changed during the game. */
    String settingsHold() {
        return replay == null ? "from the next start or restart on" : "from the next start on; a replay keeps its own";
    }

    /** Returns the request for another level, played by hand. */
    PlayRequest of(LevelName other) {
        return new PlayRequest(other, null, quality, null, record, simulation, picture);
    }
}
