package nephele.engine.sim;

import java.util.Locale;

/** What a player holds down during a tick, besides the direction of walking. */
public enum Action {
    RUN,
    CROUCH,
    JUMP;

    /** As written in a replay file. */
    public String text() {
        return name().toLowerCase(Locale.ROOT);
    }

    int bit() {
        return 1 << ordinal();
    }
}
