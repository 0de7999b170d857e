package nephele.host.playthrough;

import nephele.engine.sim.state.PlayerInput;

/** The source of the player's input: devices or a replay. */
public interface TickInput {
    /** Returns the input of the next tick. */
    PlayerInput next();

    /** Returns true when a replay has no further tick. */
    boolean isFinished();

    /** Returns this input without its turns: before a fixed camera, each key always moves in the same direction. */
    default TickInput unturned() {
        TickInput turning = this;
        return new TickInput() {
            @Override
            public PlayerInput next() {
                return turning.next().turning(0, 0);
            }

            @Override
            public boolean isFinished() {
                return turning.isFinished();
            }
        };
    }
}
