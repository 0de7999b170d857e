package nephele.engine.walk;

import nephele.engine.sim.PlayerInput;

/** Who plays: hands and mouse, or a replay. */
public interface TickInput {
    /** What is done in the next tick. */
    PlayerInput next();

    /** True when a replay has no further tick. */
    boolean isFinished();
}
