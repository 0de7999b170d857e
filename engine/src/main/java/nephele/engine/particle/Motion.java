package nephele.engine.particle;

/** Closed forms of motion under gravity and a drag in proportion to speed: v' = −k v − g. */
final class Motion {
    static final double GRAVITY = 9.81;

    private Motion() {}

    /**
     * Writes height and vertical speed to {@code y} and {@code alongY}.
     *
     * @param speed at the start, upwards
     * @param drag k, per second
     * @param kept exp(−k t)
     */
    static void fall(double speed, double drag, double seconds, double kept, ParticleState out) {
        double limit = GRAVITY / drag;
        out.y = (speed + limit) * (1 - kept) / drag - limit * seconds;
        out.alongY = (speed + limit) * kept - limit;
    }
}
