package nephele.engine.sim.state;

/**
 * The input of one tick, in integers, so that a replay repeats it exactly. Values outside their ranges are clamped.
 *
 * @param forwardPercent in percent of the speed, −100 to 100
 * @param rightPercent in percent of the speed, −100 to 100
 * @param turnLeftMillidegrees change of yaw, at most {@link #MAX_TURN_MILLIDEGREES} either way
 * @param turnUpMillidegrees change of pitch, at most {@link #MAX_TURN_MILLIDEGREES} either way
 * @param actions one bit for each {@link Action} that is held
 */
public record PlayerInput(
        int forwardPercent, int rightPercent, int turnLeftMillidegrees, int turnUpMillidegrees, int actions) {
    public static final PlayerInput NONE = new PlayerInput(0, 0, 0, 0, 0);
    public static final PlayerInput FORWARD = NONE.walking(100, 0);
    /** The greatest turn in one tick: ten revolutions, more than a hand can make. */
    public static final int MAX_TURN_MILLIDEGREES = 3_600_000;

    public PlayerInput {
        forwardPercent = Math.max(-100, Math.min(100, forwardPercent));
        rightPercent = Math.max(-100, Math.min(100, rightPercent));
        turnLeftMillidegrees = limitedTurn(turnLeftMillidegrees);
        turnUpMillidegrees = limitedTurn(turnUpMillidegrees);
        actions &= (1 << Action.ALL.size()) - 1;
    }

    private static int limitedTurn(int millidegrees) {
        return Math.max(-MAX_TURN_MILLIDEGREES, Math.min(MAX_TURN_MILLIDEGREES, millidegrees));
    }

    /** Returns this input with another walking direction, in percent. */
    public PlayerInput walking(int forward, int right) {
        return new PlayerInput(forward, right, turnLeftMillidegrees, turnUpMillidegrees, actions);
    }

    /** Returns this input with another turn, in thousandths of a degree. */
    public PlayerInput turning(int leftMillidegrees, int upMillidegrees) {
        return new PlayerInput(forwardPercent, rightPercent, leftMillidegrees, upMillidegrees, actions);
    }

    /** Returns this input with an action held as well. */
    public PlayerInput holding(Action action) {
        return new PlayerInput(
                forwardPercent, rightPercent, turnLeftMillidegrees, turnUpMillidegrees, actions | action.bit());
    }

    public boolean holds(Action action) {
        return (actions & action.bit()) != 0;
    }
}
