package nephele.host.playthrough;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.scene.FrameState;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.SimState;

/**
 * The age of each portal since its last change of place: one that a shot has just made opens gradually, and where it was
 * before it closes.
 */
final class PortalAges {
    static final double OPENING_SECONDS = 0.25;
    /** Least openness: the aperture is practically invisible, but one of no size could not be drawn. */
    private static final double LEAST_OPENNESS = 0.02;

    static final double CLOSING_SECONDS = 0.2;

    /** A portal as it was before a shot moved it. */
    private record Moved(Portal from, int colour, long tick) {}

    private static final long ALWAYS = Long.MIN_VALUE / 2;

    private final double secondsPerTick;
    private long[] madeInTick = new long[0];
    private Portals portals;
    private final List<Moved> moved = new ArrayList<>(2);

    PortalAges(SimState start, double secondsPerTick) {
        this.secondsPerTick = secondsPerTick;
        portals = start.world().portals();
        madeInTick = grown(portals.size());
    }

    private long[] grown(int size) {
        long[] longer = Arrays.copyOf(madeInTick, size);
        Arrays.fill(longer, Math.min(madeInTick.length, size), size, ALWAYS);
        return longer;
    }

    /** Follows a tick that ended in this state. */
    void after(SimState state) {
        Portals now = state.world().portals();
        if (now == portals) {
            return;
        }
        int known = Math.min(portals.size(), now.size());
        madeInTick = grown(now.size());
        for (GunPortals.Colour shot : GunPortals.Colour.BOTH) {
            int portal = state.world().shots().portal(shot);
            if (portal != GunPortals.UNFIRED && portal < known && now.portal(portal) != portals.portal(portal)) {
                moved.removeIf(earlier -> earlier.colour == shot.ordinal());
                moved.add(new Moved(portals.portal(portal), shot.ordinal(), state.tick()));
            }
        }
        for (int i = 0; i < now.size(); i++) {
            if (i >= known || now.portal(i) != portals.portal(i)) {
                madeInTick[i] = state.tick();
            }
        }
        portals = now;
    }

    /** Returns the portals that are closing, at a fraction of the tick that ends in {@code tick}. */
    List<FrameState.ClosingPortal> closing(long tick, double fraction) {
        moved.removeIf(earlier -> seconds(earlier, tick, 0) >= CLOSING_SECONDS);
        if (moved.isEmpty()) {
            return List.of();
        }
        List<FrameState.ClosingPortal> closing = new ArrayList<>(moved.size());
        for (Moved earlier : moved) {
            double left = 1 - seconds(earlier, tick, fraction) / CLOSING_SECONDS;
            if (left > 0) {
                closing.add(new FrameState.ClosingPortal(earlier.from, earlier.colour, left * left));
            }
        }
        return closing;
    }

    private double seconds(Moved earlier, long tick, double fraction) {
        return (tick - earlier.tick + fraction) * secondsPerTick;
    }

    /**
     * Returns the openness of a portal, 0 to 1, at a fraction of the tick that ends in {@code tick}: fast, then slower.
     */
    double openness(int portal, long tick, double fraction) {
        double seconds = (tick - madeInTick[portal] + fraction) * secondsPerTick;
        double left = Math.max(0, 1 - seconds / OPENING_SECONDS);
        return Math.max(LEAST_OPENNESS, 1 - left * left * left);
    }
}
