package nephele.host.playthrough;

import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.PlayerInput;

/** A replay up to a tick, and from there on another input. */
public final class TakenOverInput implements TickInput {
    private final ReplayInput replay;
    private final TickInput then;
    private final Runnable takeOver;
    private long left;

    /**
     * Begins with the replay.
     *
     * @param tick number of the replay's ticks
     * @param takeOver called once, before the first tick of the other input
     */
    public TakenOverInput(Replay replay, long tick, TickInput then, Runnable takeOver) {
        this.replay = new ReplayInput(replay);
        this.then = then;
        this.takeOver = takeOver;
        left = tick;
    }

    @Override
    public PlayerInput next() {
        if (left > 0) {
            left--;
            return replay.next();
        }
        if (left == 0) {
            left--;
            takeOver.run();
        }
        return then.next();
    }

    @Override
    public boolean isFinished() {
        return left < 0 && then.isFinished();
    }
}
