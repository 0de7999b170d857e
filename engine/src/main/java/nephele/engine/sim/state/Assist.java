package nephele.engine.sim.state;

import java.util.List;
import java.util.Locale;

/**
 * A player assistance that departs from physics. Each is enabled separately and stored in the replay; all are off in
 * physics tests.
 */
public enum Assist {
    FUNNEL,
    FLOOR_EXIT_SPEED,
    SPEED_CAP,
    /** A body that has fallen out of the world returns to its place in the level. */
    BODY_RETURN,
    /** A shot's portal whose lower edge is near above a floor slides down to it. */
    PORTAL_TO_FLOOR,
    /** A shot's portal on a floor or ceiling turns to the nearest right angle of its surface. */
    PORTAL_TURN,
    /** A walker whose move intent points into the plane of a portal beside it is led through. */
    WALK_IN,
    /** A player that has come out of a portal close to a wall or an edge is eased off it. */
    EXIT_ROOM,
    /** A player that has fallen out of the level returns to where it last stood. */
    SAFE_RETURN;

    /** The assists of the game where the player has chosen no others: all but the cap on speed. */
    public static final List<Assist> USUAL = List.of(
            FUNNEL, FLOOR_EXIT_SPEED, BODY_RETURN, PORTAL_TO_FLOOR, PORTAL_TURN, WALK_IN, EXIT_ROOM, SAFE_RETURN);

    /** Returns the name as it is written in a replay file: {@code "floor-exit-speed"}. */
    public String text() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
