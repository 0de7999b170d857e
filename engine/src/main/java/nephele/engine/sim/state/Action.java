package nephele.engine.sim.state;

import java.util.List;
import java.util.Locale;

/**
 * An input of the player that is held during a tick, besides the walking direction. JUMP and all after it act only on
 * the tick in which they are pressed.
 */
public enum Action {
    RUN,
    CROUCH,
    JUMP,
    /** Shoots the first portal. */
    FIRE_FIRST,
    /** Shoots the second portal. */
    FIRE_SECOND,
    /** Picks up the body that is looked at, or drops the held one. */
    CARRY,
    /** Throws the held body. */
    THROW;

    /** The actions of the portal gun and the hands, one bit each; {@link nephele.engine.sim.player.PlayerStep} ignores them. */
    public static final int HAND_ACTIONS = FIRE_FIRST.bit() | FIRE_SECOND.bit() | CARRY.bit() | THROW.bit();

    /** All actions, without the new array of {@link #values}. */
    public static final List<Action> ALL = List.of(values());

    /** Returns the name as it is written in a replay file: {@code "fire-first"}. */
    public String text() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    public int bit() {
        return 1 << ordinal();
    }
}
