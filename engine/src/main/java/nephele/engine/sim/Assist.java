package nephele.engine.sim;

import java.util.Locale;

/** Help that departs from physics; each is switched on alone and stored in the replay. Off in physics tests. */
public enum Assist {
    FUNNEL,
    FLOOR_EXIT_SPEED,
    SPEED_CAP;

    /** As written in a replay file: {@code "floor-exit-speed"}. */
    public String text() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
