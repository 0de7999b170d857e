package nephele.engine.sim.player;

/**
 * The exponential approach to a target over one tick, in closed form: v' = k (target − v) has v(t) = target + (v₀ −
 * target) exp(−k t), with the displacement target · t + (v₀ − target)(1 − exp(−k t)) / k. It never overshoots, and two
 * half ticks equal a whole one.
 *
 * @param share 1 − exp(−k t), the fraction of the difference that a tick removes
 * @param wayPerSpeed (1 − exp(−k t)) / k, in seconds
 * @param seconds the tick's length
 */
public record ExponentialApproach(double share, double wayPerSpeed, double seconds) {
    public static ExponentialApproach of(double ratePerSecond, double seconds) {
        double share = -StrictMath.expm1(-ratePerSecond * seconds);
        return new ExponentialApproach(share, ratePerSecond > 0 ? share / ratePerSecond : seconds, seconds);
    }

    /** Returns the value after the tick. */
    public double approach(double value, double target) {
        return target + (value - target) * (1 - share);
    }

    /** Returns the integral of the value over the tick. */
    public double displacement(double value, double target) {
        return target * seconds + (value - target) * wayPerSpeed;
    }
}
