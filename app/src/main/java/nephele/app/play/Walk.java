package nephele.app.play;

import java.util.ArrayList;
import java.util.List;
import nephele.app.draw.Viewpoints;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.scene.View;
import nephele.engine.sim.FixedStep;
import nephele.engine.sim.PlayerPose;
import nephele.engine.sim.ReplayRecorder;
import nephele.engine.sim.SimSettings;
import nephele.engine.sim.SimState;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.TickEvent;

/** The simulated part of a game: two states to draw between, the clock that makes ticks and the record of all input. */
public final class Walk {
    private final Simulation simulation;
    private final SimState start;
    private final TickInput input;
    private final ReplayRecorder recorder;
    private final FixedStep clock;
    private final List<TickEvent> news = new ArrayList<>();
    private SimState before;
    private SimState after;

    /**
     * Where a walk begins and what its recording is called.
     *
     * @param from null: where the level starts
     */
    public record Beginning(String levelFile, SimSettings settings, PlayerStart from) {}

    public Walk(Level level, Beginning beginning, TickInput input) {
        this.input = input;
        simulation = new Simulation(level, beginning.settings);
        start = beginning.from == null ? simulation.start() : simulation.startFrom(beginning.from);
        recorder = new ReplayRecorder(beginning.levelFile, beginning.settings, beginning.from);
        clock = new FixedStep(beginning.settings.ticksPerSecond());
        before = start;
        after = start;
    }

    /** Simulates the ticks that are due after a frame of this length. */
    public void advance(long elapsedNanos) {
        int due = clock.advance(elapsedNanos);
        for (int i = 0; i < due; i++) {
            tick();
        }
    }

    /** One tick. */
    public void tick() {
        var done = input.next();
        recorder.record(done);
        before = after;
        after = simulation.step(after, done);
        news.addAll(after.around().trace().events());
    }

    /** What happened since the last call. */
    List<TickEvent> takeNews() {
        List<TickEvent> taken = List.copyOf(news);
        news.clear();
        return taken;
    }

    public boolean isFinished() {
        return input.isFinished();
    }

    public SimState state() {
        return after;
    }

    public ReplayRecorder recorder() {
        return recorder;
    }

    /** The player's view between the last two ticks. */
    public View view(double aspect) {
        var pose = PlayerPose.between(before, after, clock.share());
        return Viewpoints.ofEye(pose.eye(), pose.view(), aspect);
    }
}
