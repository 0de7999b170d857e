package nephele.workshop.solve;

import java.util.function.Predicate;
import java.util.function.Supplier;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.replay.ReplayRecorder;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.ViewAngles;

/**
 * Plays a level from a script, through the same inputs as a person: turns the view at a human speed, walks, jumps,
 * shoots and carries. The inputs are recorded as a replay.
 */
public final class ScriptedPlayer {
    /** The fastest turn, an unhurried one: 216° a second at 120 ticks a second. */
    private static final int MOST_TURN_MILLIDEGREES = 1800;
    /** The fraction of the remaining angle that is turned in a tick, so that a turn ends smoothly. */
    private static final double TURN_FRACTION = 0.06;

    private static final int LEAST_TURN_MILLIDEGREES = 40;
    private static final int MOST_TICKS_OF_AN_ACT = 2400;
    private static final double THERE_METRES = 0.12;

    private final Simulation simulation;
    private final ReplayRecorder recorder;
    private SimState state;

    /** @param levelFile the level's file name in the replay */
    public ScriptedPlayer(PlacedLevel level, String levelFile) {
        simulation = new Simulation(SimLevel.of(level), SimSettings.DEFAULT);
        recorder = new ReplayRecorder(levelFile, SimSettings.DEFAULT, null);
        state = simulation.start();
    }

    public Replay replay() {
        return recorder.replay();
    }

    private void tick(PlayerInput input) {
        recorder.record(input);
        state = simulation.step(state, input);
    }

    public ScriptedPlayer pause(double seconds) {
        return hold(PlayerInput.NONE, seconds);
    }

    public ScriptedPlayer hold(PlayerInput input, double seconds) {
        long ticks = Math.round(seconds * SimSettings.DEFAULT.ticksPerSecond());
        for (long i = 0; i < ticks; i++) {
            tick(input);
        }
        return this;
    }

    /** Turns until the crosshair is on a point. */
    public ScriptedPlayer lookAt(Vec3 point) {
        ViewAngles wanted = headingTo(point);
        return lookAlong(wanted.yawMillidegrees() / 1000.0, wanted.pitchMillidegrees() / 1000.0);
    }

    /** Turns to view angles. */
    public ScriptedPlayer lookAlong(double yawDegrees, double pitchDegrees) {
        ViewAngles wanted = ViewAngles.ofDegrees(yawDegrees, pitchDegrees);
        return until(() -> turn(PlayerInput.NONE, wanted), now -> now.heading().equals(wanted), "look");
    }

    private ViewAngles headingTo(Vec3 point) {
        Vec3 eye = state.player().eye();
        double x = point.x() - eye.x();
        double y = point.y() - eye.y();
        double z = point.z() - eye.z();
        double yaw = StrictMath.toDegrees(StrictMath.atan2(-x, -z));
        return ViewAngles.ofDegrees(yaw, StrictMath.toDegrees(StrictMath.atan2(y, StrictMath.hypot(x, z))));
    }

    /** Returns the input with this tick's part of a turn added. */
    private PlayerInput turn(PlayerInput meanwhile, ViewAngles wanted) {
        ViewAngles now = state.player().heading();
        int left = (int) Math.round(StrictMath.toDegrees(now.yawRadiansTo(wanted)) * 1000);
        return meanwhile.turning(part(left), part(wanted.pitchMillidegrees() - now.pitchMillidegrees()));
    }

    private static int part(int wholeMillidegrees) {
        int most = Math.min(MOST_TURN_MILLIDEGREES, Math.max(LEAST_TURN_MILLIDEGREES, (int)
                Math.abs(wholeMillidegrees * TURN_FRACTION)));
        return Math.max(-most, Math.min(most, wholeMillidegrees));
    }

    /** Walks to a place without passing a portal, looking in the direction of movement. */
    public ScriptedPlayer walkTo(double x, double z) {
        return until(
                () -> {
                    Vec3 eye = state.player().eye();
                    ViewAngles wanted = headingTo(new Vec3(x, eye.y() - 0.05, z));
                    double off = Math.abs(state.player().heading().yawRadiansTo(wanted));
                    double left = StrictMath.hypot(x - eye.x(), z - eye.z());
                    int percent = off > 0.5 ? 0 : (int) Math.max(30, Math.min(100, 120 * left));
                    return turn(PlayerInput.NONE.walking(percent, 0), wanted);
                },
                now -> StrictMath.hypot(x - now.feet().x(), z - now.feet().z()) < THERE_METRES,
                "walk to " + x + ", " + z);
    }

    /** Holds an input, such as walking straight ahead, until a condition holds. */
    public ScriptedPlayer doUntil(PlayerInput input, Predicate<PlayerState> done) {
        return until(() -> input, done, "do " + input);
    }

    /** Holds a button for one tick and releases it for the next. */
    public ScriptedPlayer press(Action action) {
        tick(PlayerInput.NONE.holding(action));
        tick(PlayerInput.NONE);
        return this;
    }

    /** Shoots a portal at a point. */
    public ScriptedPlayer shoot(Action trigger, Vec3 at) {
        return lookAt(at).pause(0.15).press(trigger).pause(0.35);
    }

    private ScriptedPlayer until(Supplier<PlayerInput> input, Predicate<PlayerState> done, String act) {
        for (int i = 0; i < MOST_TICKS_OF_AN_ACT; i++) {
            if (done.test(state.player())) {
                return this;
            }
            tick(input.get());
        }
        throw new IllegalStateException(
                "cannot " + act + ": stands at " + state.player().feet() + " after " + state.tick() + " ticks");
    }
}
