package nephele.engine.sim;

/**
 * Exponential approach over one tick, in closed form: v' = k (target − v) has v(t) = target + (v₀ − target) exp(−k t),
 * and its way is target · t + (v₀ − target)(1 − exp(−k t)) / k. Never overshoots, and two half ticks equal one whole.
 */
record Damping(double share, double wayPerSpeed, double seconds) {
    static Damping of(double ratePerSecond, double seconds) {
        double share = -StrictMath.expm1(-ratePerSecond * seconds);
        return new Damping(share, ratePerSecond > 0 ? share / ratePerSecond : seconds, seconds);
    }

    /** The value after the tick. */
    double approach(double value, double target) {
        return target + (value - target) * (1 - share);
    }

    /** The integral of the value over the tick. */
    double way(double value, double target) {
        return target * seconds + (value - target) * wayPerSpeed;
    }
}
