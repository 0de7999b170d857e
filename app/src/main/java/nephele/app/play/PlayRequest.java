package nephele.app.play;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Objects;
import java.util.function.Consumer;
import nephele.app.settings.PlayerFiles;
import nephele.app.settings.Settings;
import nephele.app.window.GameWindow;
import nephele.app.window.InputListener;
import nephele.engine.level.Language;
import nephele.engine.level.PlayerStart;
import nephele.engine.render.gl.GlContext;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.SimSettings;
import nephele.host.compare.TechniquePair;
import nephele.host.draw.QualityChoice;
import nephele.host.named.LevelName;

/**
 * The options of a game.
 *
 * @param level null for the title
 * @param from null for the level's start
 * @param quality null for that of the player's settings
 * @param shown null for keyboard and mouse
 * @param record null if nothing is recorded
 * @param simulation null for that of the player's settings
 * @param compared two techniques that draw the clouds, one on each side of a wipe; null for those of the level
 */
public record PlayRequest(
        LevelName level,
        PlayerStart from,
        QualityChoice quality,
        Shown shown,
        Path record,
        SimSettings simulation,
        TechniquePair compared,
        Picture picture,
        Player player) {
    /** The picture's size in pixels, and true for full screen. */
    public record Picture(int width, int height, boolean fullScreen) {}

    /**
     * A replay to show.
     *
     * @param takeOverTick the tick from which the player plays; {@link #NEVER} to show all of it
     */
    public record Shown(Replay replay, long takeOverTick) {
        public static final long NEVER = Long.MAX_VALUE;

        boolean isTakenOver() {
            return takeOverTick != NEVER;
        }
    }

    /**
     * The player's files, log and viewer of scenes.
     *
     * @param log receives a line for each change of the game's state; null for none
     * @param scenes shows the XML scenes of the menu
     */
    public record Player(PlayerFiles files, PrintStream log, SceneViewing scenes) {
        /** Creates the player of a game whose menu shows no scenes. */
        public Player(PlayerFiles files, PrintStream log) {
            this(files, log, (file, title, screen, complaints) -> {});
        }
    }

    /** The viewer of XML scenes. The command line hands it in: the game knows of a scene only its file. */
    @FunctionalInterface
    public interface SceneViewing {
        /**
         * Shows a scene until the player leaves it. Afterwards the window has the game's input, and the scene's title.
         *
         * @param title of the window meanwhile
         * @param complaints receives what is wrong with the scene, a line each
         */
        void show(String file, String title, Screen screen, Consumer<String> complaints);

        /**
         * The game's window as the viewer borrows it.
         *
         * @param own the game's input, which the window has again afterwards
         */
        record Screen(GameWindow window, InputListener own, GlContext gl, Language language) {}
    }

    /** Returns the replay to show; null for keyboard and mouse. */
    Replay replay() {
        return shown == null ? null : shown.replay();
    }

    /** Returns true if the player's hands move the character in the end, not a replay alone. */
    boolean isPlayed() {
        return shown == null || shown.isTakenOver();
    }

    /** Returns true if the player's hands move the character from the level's start on. */
    boolean isPlayedFromStart() {
        return shown == null && from == null;
    }

    /**
     * Returns true if what is reached counts as the player's progress and may be a record: only what is played by hand,
     * from the level's start, with the rate and the assists of the player's settings.
     */
    boolean isRanked() {
        return isPlayedFromStart()
                && settings().equals(player.files().settings().simulation());
    }

    /** Returns the simulation's settings: those of the command line, else the player's. */
    SimSettings settings() {
        return simulation != null ? simulation : player.files().settings().simulation();
    }

    /** Returns the quality of the command line, else the player's. */
    QualityChoice chosenQuality() {
        return quality != null ? quality : player.files().settings().quality();
    }

    /** Returns true if the quality follows the frame rate. Allocates nothing: frames ask for it. */
    boolean isQualityAutomatic() {
        return quality != null
                ? quality.isAuto()
                : player.files().settings().get(Settings.QUALITY) == Settings.QualityPreset.AUTO;
    }

    /** Returns this request with another start; null for the level's. */
    PlayRequest from(PlayerStart start) {
        return new PlayRequest(level, start, quality, shown, record, simulation, compared, picture, player);
    }

    /** Returns the request for another level, played by hand, with its own clouds. */
    PlayRequest of(LevelName other) {
        return new PlayRequest(other, null, quality, null, record, simulation, null, picture, player);
    }

    /** Returns this request with the clouds drawn by two techniques. */
    PlayRequest comparing(TechniquePair techniques) {
        return new PlayRequest(level, from, quality, shown, record, simulation, techniques, picture, player);
    }

    /** Returns true if another request shows the same level in the same way. */
    boolean shows(PlayRequest other) {
        return level.equals(other.level) && Objects.equals(compared, other.compared);
    }
}
