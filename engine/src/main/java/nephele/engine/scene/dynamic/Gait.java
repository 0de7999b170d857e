package nephele.engine.scene.dynamic;

/**
 * The positions of the feet during walking. The cycle's length follows from the speed, and a foot on the ground moves
 * back as fast as the body moves forward, so it does not slide at any speed. Cadence and the fraction of time on the
 * ground approximate human walking and running (Alexander 1989, "Optimization and gaits in the locomotion of
 * vertebrates", section III).
 */
public final class Gait {
    /** The speed at stride 1. */
    public static final double WALKING_METRES_PER_SECOND = 4;

    private static final double SLOWEST_CYCLES_PER_SECOND = 0.9;
    private static final double CYCLES_PER_SECOND_PER_STRIDE = 0.75;
    /** The greatest travel of a foot relative to the body between first and last contact. */
    private static final double LONGEST_CONTACT_METRES = 0.75;

    private static final double LONGEST_CONTACT_FRACTION = 0.6;

    private Gait() {}

    /** Returns the walking cycles (of two steps) per second at {@code stride}. */
    public static double cyclesPerSecond(double stride) {
        return SLOWEST_CYCLES_PER_SECOND + CYCLES_PER_SECOND_PER_STRIDE * stride;
    }

    /** Returns the distance covered by one cycle, metres. */
    public static double cycleMetres(double stride) {
        return WALKING_METRES_PER_SECOND * stride / cyclesPerSecond(stride);
    }

    /** Returns the fraction of a cycle during which a foot is on the ground. */
    static double contactFraction(double stride) {
        return Math.min(LONGEST_CONTACT_FRACTION, LONGEST_CONTACT_METRES / Math.max(cycleMetres(stride), 1e-9));
    }

    /**
     * The position of a foot at one phase of the cycle.
     *
     * @param along metres in front of the body's centre
     * @param lift height of the ankle as a fraction of the greatest
     * @param pitch rotation about the ball, in radians before scaling; greatest with the heel up, negative with the
     *     toes up
     */
    record Foot(double along, double lift, double pitch) {}

    /**
     * Returns the position of a foot.
     *
     * @param phase fraction of the cycle since this foot touched the ground, 0 to 1
     */
    static Foot foot(double phase, double stride) {
        double fraction = contactFraction(stride);
        double length = fraction * cycleMetres(stride);
        if (phase < fraction) {
            double t = phase / fraction;
            double toesUp = -0.3 * Math.max(0, 1 - t / 0.2);
            double heelUp = smooth((t - 0.6) / 0.4);
            return new Foot(length * (0.5 - t), 0, toesUp + 0.75 * heelUp);
        }
        double t = (phase - fraction) / (1 - fraction);
        // The foot leaves and touches the ground with the ground's own velocity.
        double speed = -length * (1 - fraction) / fraction;
        double along = hermite(t, -length / 2, length / 2, speed);
        double pitch = t < 0.35 ? 0.75 + 0.25 * smooth(t / 0.35) : 1 - 1.3 * smooth((t - 0.35) / 0.6);
        return new Foot(along, Math.pow(Math.sin(Math.PI * t), 1.5), pitch);
    }

    static double smooth(double x) {
        double t = Math.max(0, Math.min(1, x));
        return t * t * (3 - 2 * t);
    }

    /** Returns the cubic from a to b with the same slope at both ends. */
    private static double hermite(double t, double a, double b, double slope) {
        double s = smooth(t);
        return a + (b - a) * s + slope * (t * (1 - t) * (1 - t) - t * t * (1 - t));
    }
}
