package nephele.engine.sim;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.PlayerStart;

/** Writes down what is done, tick by tick or in longer stretches: records a game, and authors a replay in code. */
public final class ReplayRecorder {
    private final String level;
    private final SimSettings settings;
    private final PlayerStart start;
    private final List<Replay.Run> runs = new ArrayList<>();
    private PlayerInput current = PlayerInput.NONE;
    private int ticks;

    /** @param start {@code null}: where the level starts */
    public ReplayRecorder(String level, SimSettings settings, PlayerStart start) {
        this.level = level;
        this.settings = settings;
        this.start = start;
    }

    /** One tick. */
    public ReplayRecorder record(PlayerInput input) {
        return record(input, 1);
    }

    /** The same for several ticks. */
    public ReplayRecorder record(PlayerInput input, int forTicks) {
        if (!input.equals(current)) {
            flush();
            current = input;
        }
        ticks += forTicks;
        return this;
    }

    /** Holds for a time, rounded to ticks. */
    public ReplayRecorder hold(PlayerInput input, double seconds) {
        return record(input, (int) Math.round(seconds * settings.ticksPerSecond()));
    }

    /** Turns by an angle while doing something else, in equal parts; the last tick takes what does not divide. */
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

    /** What has been recorded so far. */
    public Replay replay() {
        flush();
        return new Replay(level, settings, start, List.copyOf(runs));
    }
}
