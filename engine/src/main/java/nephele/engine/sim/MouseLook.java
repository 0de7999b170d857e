package nephele.engine.sim;

/**
 * Mouse counts to whole thousandths of a degree. What is less than one is kept for the next time, so that a slow hand
 * turns as far as a fast one.
 */
public final class MouseLook {
    private final double millidegreesPerCount;
    private double restLeft;
    private double restUp;

    public MouseLook(double degreesPerCount) {
        millidegreesPerCount = degreesPerCount * 1000;
    }

    /** @param right counts to the right; {@code down} counts downwards, as windows report them */
    public PlayerInput turn(PlayerInput input, double right, double down) {
        restLeft = kept(restLeft - right * millidegreesPerCount);
        restUp = kept(restUp - down * millidegreesPerCount);
        int left = (int) restLeft;
        int up = (int) restUp;
        restLeft -= left;
        restUp -= up;
        return input.turning(left, up);
    }

    private static double kept(double millidegrees) {
        double most = PlayerInput.MAX_TURN_MILLIDEGREES;
        return Double.isFinite(millidegrees) ? Math.max(-most, Math.min(most, millidegrees)) : 0;
    }
}
