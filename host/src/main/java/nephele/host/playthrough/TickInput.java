package nephele.host.playthrough;

import nephele.engine.sim.state.PlayerInput;

/** The source of the player's input: devices or a replay. */
public interface TickInput {
    /** Returns the input of the next tick. */
    PlayerInput next();

    /** Returns true when a replay has no further tick. */
    boolean isFinished();
}
