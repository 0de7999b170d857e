package nephele.app.play;

import java.util.EnumSet;
import java.util.Set;

/** The state of the game; {@link #next} is the complete transition table. */
public enum GameStage {
    /** The window and the context are being opened. */
    INITIALISING,
    /** The title menu is open; a level behind it is only shown. */
    TITLE,
    /** The menu is open; a level behind it is paused. */
    MENU,
    /** A level is being read and its resources built. */
    STARTING,
    /** The level runs. */
    RUNNING,
    /** The player has reached the exit; the level stands still. */
    ENDED,
    /** The same level starts again. */
    RESTARTING,
    /** Everything is being closed; no state follows. */
    LEAVING;

    /** Returns the stages that may follow this one. */
    public Set<GameStage> next() {
        return switch (this) {
            case INITIALISING -> EnumSet.of(TITLE, MENU, STARTING, LEAVING);
            case TITLE -> EnumSet.of(STARTING, RESTARTING, LEAVING);
            case MENU -> EnumSet.of(TITLE, STARTING, RUNNING, RESTARTING, LEAVING);
            case STARTING -> EnumSet.of(RUNNING, TITLE, MENU, ENDED, LEAVING);
            case RUNNING -> EnumSet.of(MENU, ENDED, RESTARTING, LEAVING);
            case ENDED -> EnumSet.of(TITLE, STARTING, RESTARTING, LEAVING);
            case RESTARTING -> EnumSet.of(RUNNING, LEAVING);
            case LEAVING -> EnumSet.noneOf(GameStage.class);
        };
    }
}
