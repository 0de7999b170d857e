package nephele.engine.sim.state;

import java.util.List;
import java.util.Locale;

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

    /**
     * An input of the player that is held during a tick, besides the walking direction. JUMP and all after it act only on
     * the tick in which they are pressed.
     */
    public enum Action {
        RUN,
        CROUCH,
        JUMP,
        /** Shoots the first portal. */
        FIRE_FIRST,
        /** Shoots the second portal. */
        FIRE_SECOND,
        /** Picks up the body that is looked at, or drops the held one. */
        CARRY,
        /** Throws the held body. */
        THROW;

        /** The actions of the portal gun and the hands, one bit each; {@link nephele.engine.sim.player.PlayerStep} ignores them. */
        public static final int HAND_ACTIONS = FIRE_FIRST.bit() | FIRE_SECOND.bit() | CARRY.bit() | THROW.bit();

        /** All actions, without the new array of {@link #values}. */
        public static final List<Action> ALL = List.of(values());

        /** Returns the name as it is written in a replay file: {@code "fire-first"}. */
        public String text() {
            return name().toLowerCase(Locale.ROOT).replace('_', '-');
        }

        public int bit() {
            return 1 << ordinal();
        }
    }
}
