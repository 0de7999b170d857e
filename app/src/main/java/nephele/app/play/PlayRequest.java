package nephele.app.play;

import java.nio.file.Path;
import nephele.engine.draw.QualityChoice;
import nephele.engine.level.PlayerStart;
import nephele.engine.named.LevelName;
import nephele.engine.sim.Replay;
import nephele.engine.sim.SimSettings;

/**
 * What the player asked for.
 *
 * @param from null: where the level starts
 * @param replay null: keyboard and mouse
 * @param record null: nothing is kept
 */
public record PlayRequest(
        LevelName level,
        PlayerStart from,
        QualityChoice quality,
        Replay replay,
        Path record,
        SimSettings simulation,
        Picture picture) {
    /** How large, and whether over the whole screen. */
    public record Picture(int width, int height, boolean fullScreen) {}

    PlayRequest with(SimSettings changed) {
        return new PlayRequest(level, from, quality, replay, record, changed, picture);
    }

    /** From when on settings hold that are changed while this is played, in words. */
    String settingsHold() {
        return replay == null ? "from the next start or restart on" : "from the next start on; a replay keeps its own";
    }

    /** The same for another level, played by hand. */
    PlayRequest of(LevelName other) {
        return new PlayRequest(other, null, quality, null, record, simulation, picture);
    }
}
