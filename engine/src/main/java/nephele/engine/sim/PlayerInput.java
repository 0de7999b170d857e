package nephele.engine.sim;

/**
 * All that a player does in one tick, in whole numbers, so that a replay repeats it exactly.
 *
 * @param forwardPercent of the walking speed, −100 to 100
 * @param rightPercent of the walking speed, −100 to 100
 * @param turnLeftMillidegrees change of yaw
 * @param turnUpMillidegrees change of pitch
 * @param actions one bit for each {@link Action} that is held
 */
public record PlayerInput(
        int forwardPercent, int rightPercent, int turnLeftMillidegrees, int turnUpMillidegrees, int actions) {
    public static final PlayerInput NONE = new PlayerInput(0, 0, 0, 0, 0);
    public static final PlayerInput FORWARD = NONE.walking(100, 0);
    /** A turn of more than this in one tick is no turn that a hand makes: ten revolutions. */
    public static final int MAX_TURN_MILLIDEGREES = 3_600_000;

    public PlayerInput {
        forwardPercent = Math.max(-100, Math.min(100, forwardPercent));
        rightPercent = Math.max(-100, Math.min(100, rightPercent));
        turnLeftMillidegrees = limitedTurn(turnLeftMillidegrees);
        turnUpMillidegrees = limitedTurn(turnUpMillidegrees);
        actions &= (1 << Action.values().length) - 1;
    }

    private static int limitedTurn(int millidegrees) {
        return Math.max(-MAX_TURN_MILLIDEGREES, Math.min(MAX_TURN_MILLIDEGREES, millidegrees));
    }

    public PlayerInput walking(int forward, int right) {
        return new PlayerInput(forward, right, turnLeftMillidegrees, turnUpMillidegrees, actions);
    }

    public PlayerInput turning(int leftMillidegrees, int upMillidegrees) {
        return new PlayerInput(forwardPercent, rightPercent, leftMillidegrees, upMillidegrees, actions);
    }

    public PlayerInput holding(Action action) {
        return new PlayerInput(
                forwardPercent, rightPercent, turnLeftMillidegrees, turnUpMillidegrees, actions | action.bit());
    }

    public boolean holds(Action action) {
        return (actions & action.bit()) != 0;
    }
}
