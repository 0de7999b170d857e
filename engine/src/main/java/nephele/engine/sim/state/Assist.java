package nephele.engine.sim.state;

import java.util.Locale;

/**
 * A player assistance that departs from physics. Each is enabled separately and stored in the replay; all are off in
 * physics tests.
 */
public enum Assist {
    FUNNEL,
    FLOOR_EXIT_SPEED,
    SPEED_CAP;

    /** Returns the name as it is written in a replay file: {@code "floor-exit-speed"}. */
    public String text() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
