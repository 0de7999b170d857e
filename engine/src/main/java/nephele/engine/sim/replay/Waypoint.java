package nephele.engine.sim.replay;

import java.util.List;
import nephele.engine.level.Range;
import nephele.engine.level.Spatial;
import nephele.engine.level.Written;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;

/**
 * The player's place after a tick of a recording.
 *
 * @param tick the number of ticks since the start
 * @param opened the shots that placed a portal in this tick
 */
public record Waypoint(
        @Written(required = true) @Range(min = 1, max = Integer.MAX_VALUE) int tick,
        @Written(required = true, spatial = Spatial.POINT) @Range Vec3 feet,
        @Written(most = 2) List<GunPortals.Colour> opened) {
    /** Number of ticks between two places, a quarter of a second at the usual rate. */
    private static final int INTERVAL_TICKS = 30;

    /** Returns true for the states that a track lists: at regular intervals, and where a portal opened or the level ended. */
    static boolean isDue(SimState state) {
        return state.tick() % INTERVAL_TICKS == 0
                || state.world().trace().events().stream()
                        .anyMatch(event ->
                                event instanceof TickEvent.PortalOpened || event instanceof TickEvent.ExitReached);
    }

    static Waypoint of(SimState state) {
        return new Waypoint((int) state.tick(), state.player().feet(), opened(state));
    }

    /** Returns the shots that placed a portal in a state's last tick. */
    public static List<GunPortals.Colour> opened(SimState state) {
        return state.world().trace().events().stream()
                .filter(TickEvent.PortalOpened.class::isInstance)
                .map(event -> ((TickEvent.PortalOpened) event).shot())
                .toList();
    }
}
