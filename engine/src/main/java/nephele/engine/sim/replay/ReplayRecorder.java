package nephele.engine.sim.replay;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.PlayerStart;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.SimSettings;

/** Records inputs, tick by tick or in longer runs: for recording a game and for authoring a replay in code. */
public final class ReplayRecorder {
    private final String level;
    private final SimSettings settings;
    private final PlayerStart start;
    private final List<Replay.Run> runs = new ArrayList<>();
    private PlayerInput current = PlayerInput.NONE;
    private int ticks;

    /** @param start where the player starts, {@code null} for the level's start */
    public ReplayRecorder(String level, SimSettings settings, PlayerStart start) {
        this.level = level;
        this.settings = settings;
        this.start = start;
    }

    /** Records one tick. */
    public ReplayRecorder record(PlayerInput input) {
        return record(input, 1);
    }

    /** Records the same input for several ticks. */
    public ReplayRecorder record(PlayerInput input, int forTicks) {
        if (!input.equals(current)) {
            flush();
            current = input;
        }
        ticks += forTicks;
        return this;
    }

    /** Records the same input for a time, rounded to ticks. */
    public ReplayRecorder hold(PlayerInput input, double seconds) {
        return record(input, (int) Math.round(seconds * settings.ticksPerSecond()));
    }

    /** Records a turn in equal parts besides another input; the last tick gets the remainder. */
    public ReplayRecorder turn(PlayerInput meanwhile, double leftDegrees, double upDegrees, double seconds) {
        int parts = Math.max(1, (int) Math.round(seconds * settings.ticksPerSecond()));
        int left = (int) Math.round(leftDegrees * 1000);
        int up = (int) Math.round(upDegrees * 1000);
        record(meanwhile.turning(left / parts, up / parts), parts - 1);
        return record(meanwhile.turning(left - left / parts * (parts - 1), up - up / parts * (parts - 1)));
    }

    private void flush() {
        if (ticks > 0) {
            runs.add(Replay.Run.of(current, ticks));
            ticks = 0;
        }
    }

    /** Returns all that has been recorded so far. */
    public Replay replay() {
        flush();
        return new Replay(level, settings, start, List.copyOf(runs));
    }
}
