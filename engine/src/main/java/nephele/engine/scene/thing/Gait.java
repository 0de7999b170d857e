package nephele.engine.scene.thing;

/**
 * When a foot is where while the figure walks. The cycle's length follows from the speed, and a standing foot goes back
 * as fast as the body goes forward: it does not slide at any speed. Cadence and the share of time on the ground after
 * the usual course of human walking and running (Alexander 1989, "Optimization and gaits in the locomotion of
 * vertebrates", section III).
 */
public final class Gait {
    /** What stride 1 means. */
    public static final double WALKING_METRES_PER_SECOND = 4;

    private static final double SLOWEST_CYCLES_PER_SECOND = 0.9;
    private static final double CYCLES_PER_SECOND_PER_STRIDE = 0.75;
    /** No leg reaches farther from first to last contact. */
    private static final double LONGEST_CONTACT_METRES = 0.9;

    private static final double LONGEST_CONTACT_SHARE = 0.6;

    private Gait() {}

    /** Cycles of two steps that a second takes at a speed of {@code stride}. */
    public static double cyclesPerSecond(double stride) {
        return SLOWEST_CYCLES_PER_SECOND + CYCLES_PER_SECOND_PER_STRIDE * stride;
    }

    /** What one cycle covers. */
    public static double cycleMetres(double stride) {
        return WALKING_METRES_PER_SECOND * stride / cyclesPerSecond(stride);
    }

    /** Share of a cycle that a foot is on the ground. */
    static double contactShare(double stride) {
        return Math.min(LONGEST_CONTACT_SHARE, LONGEST_CONTACT_METRES / Math.max(cycleMetres(stride), 1e-9));
    }
}
