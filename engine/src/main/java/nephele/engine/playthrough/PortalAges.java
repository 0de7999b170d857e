package nephele.engine.playthrough;

import java.util.Arrays;
import nephele.engine.portal.Portals;
import nephele.engine.sim.state.SimState;

/** The age of each portal since its last change of place: one that a shot has just made opens gradually. */
final class PortalAges {
    static final double OPENING_SECONDS = 0.25;
    /** Least openness: the aperture is practically invisible, but one of no size could not be drawn. */
    private static final double LEAST_OPENNESS = 0.02;

    private static final long ALWAYS = Long.MIN_VALUE / 2;

    private final double secondsPerTick;
    private long[] madeInTick = new long[0];
    private Portals portals;

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
        for (int i = 0; i < now.size(); i++) {
            if (i >= known || now.portal(i) != portals.portal(i)) {
                madeInTick[i] = state.tick();
            }
        }
        portals = now;
    }

    /**
     * Returns the openness of a portal, 0 to 1, at a share of the tick that ends in {@code tick}: fast, then slower.
     */
    double openness(int portal, long tick, double share) {
        double seconds = (tick - madeInTick[portal] + share) * secondsPerTick;
        double left = Math.max(0, 1 - seconds / OPENING_SECONDS);
        return Math.max(LEAST_OPENNESS, 1 - left * left * left);
    }
}
