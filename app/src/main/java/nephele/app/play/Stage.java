package nephele.app.play;

import java.util.EnumSet;
import java.util.Set;

/** What the game is doing; {@link #next} is the whole table of what may follow. */
public enum Stage {
    /** Opening the window and the context. */
    INITIALISING,
    /** The menu is open; a level behind it stands still. */
    MENU,
    /** Reading a level and building what it requires. */
    STARTING,
    /** The level runs. */
    RUNNING,
    /** The same level again from its start. */
    RESTARTING,
    /** Closing everything; nothing follows. */
    LEAVING;

    /** The stages that may follow this one. */
    public Set<Stage> next() {
        return switch (this) {
            case INITIALISING -> EnumSet.of(MENU, STARTING, LEAVING);
            case MENU -> EnumSet.of(STARTING, RUNNING, RESTARTING, LEAVING);
            case STARTING -> EnumSet.of(RUNNING, MENU, LEAVING);
            case RUNNING -> EnumSet.of(MENU, RESTARTING, LEAVING);
            case RESTARTING -> EnumSet.of(RUNNING, LEAVING);
            case LEAVING -> EnumSet.noneOf(Stage.class);
        };
    }
}
