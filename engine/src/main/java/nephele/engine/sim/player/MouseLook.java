package nephele.engine.sim.player;

import nephele.engine.sim.state.PlayerInput;

/**
 * Converts mouse counts to whole thousandths of a degree. The remainder is kept for the next call, so that slow motion
 * turns as far as fast motion.
 */
public final class MouseLook {
    private final double millidegreesPerCount;
    private double restLeft;
    private double restUp;

    /** @param degreesPerCount the mouse sensitivity, degrees of turn for one count */
    public MouseLook(double degreesPerCount) {
        millidegreesPerCount = degreesPerCount * 1000;
    }

    /**
     * Adds a turn to an input.
     *
     * @param right counts to the right
     * @param down counts downwards, as windows report them
     */
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
