package nephele.host.playthrough;

import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.PlayerInput;

/** The input of a replay, tick by tick; no input after its end. */
public final class ReplayInput implements TickInput {
    private final Replay replay;
    private int run;
    private int tickOfRun;

    /** Starts at the first tick of a replay. */
    public ReplayInput(Replay replay) {
        this.replay = replay;
    }

    @Override
    public PlayerInput next() {
        if (isFinished()) {
            return PlayerInput.NONE;
        }
        var current = replay.inputs().get(run);
        tickOfRun++;
        if (tickOfRun >= current.ticks()) {
            tickOfRun = 0;
            run++;
        }
        return current.input();
    }

    @Override
    public boolean isFinished() {
        return run >= replay.inputs().size();
    }
}
