package nephele.engine.sim;

/**
 * The exponential approach to a target over one tick, in closed form: v' = k (target − v) has v(t) = target + (v₀ −
 * target) exp(−k t), with the displacement target · t + (v₀ − target)(1 − exp(−k t)) / k. It never overshoots, and two
 * half ticks equal a whole one.
 *
 * @param share 1 − exp(−k t), the fraction of the difference that a tick removes
 * @param wayPerSpeed (1 − exp(−k t)) / k, in seconds
 * @param seconds the tick's length
 */
record Damping(double share, double wayPerSpeed, double seconds) {
    static Damping of(double ratePerSecond, double seconds) {
        double share = -StrictMath.expm1(-ratePerSecond * seconds);
        return new Damping(share, ratePerSecond > 0 ? share / ratePerSecond : seconds, seconds);
    }

    /** Returns the value after the tick. */
    double approach(double value, double target) {
        return target + (value - target) * (1 - share);
    }

    /** Returns the integral of the value over the tick. */
    double way(double value, double target) {
        return target * seconds + (value - target) * wayPerSpeed;
    }
}
