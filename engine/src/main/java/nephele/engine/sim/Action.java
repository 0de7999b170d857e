package nephele.engine.sim;

import java.util.Locale;

/** What a player holds down during a tick, besides the direction of walking. From JUMP on, only pressing counts. */
public enum Action {
    RUN,
    CROUCH,
    JUMP,
    /** Shoots the first portal. */
    FIRE_FIRST,
    /** Shoots the second portal. */
    FIRE_SECOND,
    /** Picks up what is looked at, or lets go of what is held. */
    CARRY,
    /** Throws what is held. */
    THROW;

    /** The actions of portal gun and hands; the player's own body knows nothing of them. */
    static final int OF_HANDS = FIRE_FIRST.bit() | FIRE_SECOND.bit() | CARRY.bit() | THROW.bit();

    /** As written in a replay file. */
    public String text() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    int bit() {
        return 1 << ordinal();
    }
}
