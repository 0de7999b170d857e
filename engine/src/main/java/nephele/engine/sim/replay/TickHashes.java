package nephele.engine.sim.replay;

import java.util.Locale;
import java.util.function.Consumer;
import nephele.engine.sim.state.SimState;

/** Prints the lines of {@code simulate}: {@code tick hash}, for every n-th tick. */
public final class TickHashes implements Replay.TickListener {
    private final long every;
    private final long last;
    private final Consumer<String> lines;

    /** @param last the last tick, which is always printed */
    public TickHashes(long every, long last, Consumer<String> lines) {
        this.every = every;
        this.last = last;
        this.lines = lines;
    }

    @Override
    public void ticked(SimState state) {
        if (state.tick() % every == 0 || state.tick() == last) {
            lines.accept(line(state));
        }
    }

    /** Returns the line of a state; the hash has sixteen hexadecimal digits. */
    public static String line(SimState state) {
        return String.format(Locale.ROOT, "%d %016x", state.tick(), state.hash());
    }
}
