package nephele.app.play;

import java.util.ArrayList;
import java.util.List;
import nephele.app.draw.Viewpoints;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portals;
import nephele.engine.scene.Moment;
import nephele.engine.scene.View;
import nephele.engine.sim.FaultLog;
import nephele.engine.sim.FixedStep;
import nephele.engine.sim.PlayerPose;
import nephele.engine.sim.PlayerState;
import nephele.engine.sim.ReplayRecorder;
import nephele.engine.sim.SimLevel;
import nephele.engine.sim.SimSettings;
import nephele.engine.sim.SimState;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.TickEvent;

/** The simulated part of a game: two states to draw between, the clock that makes ticks and the record of all input. */
public final class Walk {
    /** A way longer than the velocities of its ends account for, and this, is no way: the player began again. */
    private static final double LEAP_METRES = 1;

    private final Simulation simulation;
    private final double secondsPerTick;
    private final TickInput input;
    private final ReplayRecorder recorder;
    private final FixedStep clock;
    private final List<TickEvent> news = new ArrayList<>();
    private final PortalAges ages;
    private final LiveMoment live;
    private final Boom boom;
    private SimState before;
    private SimState after;
    private PlayerPose pose;
    private SimState posedAfter;
    private double posedShare;
    private Limbs limbsBefore = Limbs.STANDING;
    private Limbs limbsAfter = Limbs.STANDING;

    /**
     * Where a walk begins and what its recording is called.
     *
     * @param from null: where the level starts
     */
    public record Beginning(String levelFile, SimSettings settings, PlayerStart from) {}

    public Walk(Level level, Beginning beginning, TickInput input) {
        this.input = input;
        SimLevel simLevel = SimLevel.of(level);
        simulation = new Simulation(simLevel, beginning.settings, FaultLog.SILENT);
        SimState start = beginning.from == null ? simulation.start() : simulation.startFrom(beginning.from);
        secondsPerTick = 1.0 / beginning.settings.ticksPerSecond();
        recorder = new ReplayRecorder(beginning.levelFile, beginning.settings, beginning.from);
        clock = new FixedStep(beginning.settings.ticksPerSecond());
        before = start;
        after = start;
        ages = new PortalAges(start, secondsPerTick);
        live = new LiveMoment(level);
        boom = new Boom(simLevel.statics(), secondsPerTick);
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
        ages.after(after);
        limbsBefore = limbsAfter;
        limbsAfter = limbsAfter.next(after, secondsPerTick);
        if (isLeap()) {
            before = after;
            limbsBefore = limbsAfter;
            boom.cut();
        } else {
            boom.tick(before, after);
        }
    }

    private boolean isLeap() {
        PlayerState from = before.player();
        PlayerState to = after.player();
        CrossingWord crossed = after.around().trace().playerCrossed();
        Portals portals = after.around().portals();
        Vec3 place = from.centre();
        for (int i = 0; i < crossed.length(); i++) {
            place = portals.passage(crossed.entry(i)).point(place);
        }
        double metres = to.centre().toVector().distance(place.toVector());
        double speed =
                from.velocity().toVector().length() + to.velocity().toVector().length();
        return metres > LEAP_METRES + speed * secondsPerTick;
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

    /** From the first to the third person or back. */
    public void changePerson() {
        boom.toggle();
    }

    /** The player's view between the last two ticks: from the eye, or along the boom. */
    public View view(double aspect) {
        PlayerPose camera = boom.isOut() ? boom.camera(before, after, clock.share()) : pose();
        return Viewpoints.ofEye(camera.eye(), camera.view(), aspect);
    }

    /** What is to be seen between the last two ticks; the same object every time. */
    public Moment moment() {
        double share = clock.share();
        double seconds = Math.max(0, after.tick() - 1 + share) * secondsPerTick;
        live.world(before, after, share, ages);
        live.figure(pose(), limbsBefore.towards(limbsAfter, share), seconds);
        return live.moment();
    }

    /** View and moment of one frame share it. */
    private PlayerPose pose() {
        if (posedAfter != after || posedShare != clock.share()) {
            posedAfter = after;
            posedShare = clock.share();
            pose = PlayerPose.between(before, after, posedShare);
        }
        return pose;
    }
}
