package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.math.Basis;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import nephele.engine.sim.player.PlayerPose;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.replay.ReplayRecorder;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** After a ceiling portal or a rotated pair the view turns upright gradually and never flips. */
final class UprightViewTest {
    private static final double TICK = 1.0 / 120;
    /**
     * View angles are rounded to a thousandth of a degree, and the pitch ends a tenth of a degree before the vertical.
     */
    private static final double ROUNDING = Math.toRadians(0.11);

    /**
     * Returns rooms with portals from a wall into the ceiling, from a floor into a wall, and from a floor into the
     * ceiling.
     */
    private static List<Lab> turns(SimSettings settings) {
        Vec3 wall = new Vec3(0, 1.05, -8);
        Vec3 floor = new Vec3(0, 0, -3);
        Vec3 ceiling = new Vec3(3, 6, 3);
        Vec3 side = new Vec3(8, 1.05, 3);
        return List.of(
                Lab.hall()
                        .pair(wall, new Vec3(0, 0, 1), ceiling, new Vec3(0, -1, 0))
                        .startAt(0, 0, -6.5, 0, 0)
                        .with(settings),
                Lab.hall()
                        .pair(floor, new Vec3(0, 1, 0), side, new Vec3(-1, 0, 0))
                        .startAt(0, 0, -1.6, 0, -30)
                        .with(settings),
                Lab.hall()
                        .pair(floor, new Vec3(0, 1, 0), ceiling, new Vec3(0, -1, 0))
                        .startAt(0, 0, -1.6, 20, -60)
                        .with(settings));
    }

    private static SimSettings rate(int degreesPerSecond) {
        return SimSettings.DEFAULT.withUprightDegreesPerSecond(degreesPerSecond);
    }

    private static Quaterniond turn(Basis view) {
        return Rotations.ofAxes(view.right(), view.up(), view.back());
    }

    private static double angle(Basis a, Basis b) {
        Quaterniond d = turn(a).conjugate().mul(turn(b));
        return 2 * StrictMath.atan2(Math.sqrt(d.x * d.x + d.y * d.y + d.z * d.z), Math.abs(d.w));
    }

    /** No tick turns the view by more than the rate, not even the one of the crossing. */
    @Test
    void theViewEases() {
        for (int degrees : new int[] {45, 360, 900}) {
            for (Lab lab : turns(rate(degrees))) {
                boolean crossed = false;
                for (int tick = 0; tick < 400; tick++) {
                    SimState before = lab.state();
                    SimState after = lab.tick(crossed ? PlayerInput.NONE : PlayerInput.FORWARD)
                            .state();
                    crossed |= after.world().trace().playerCrossed().length() > 0;
                    double turned = angle(
                            PlayerPose.between(before, after, 0).later(),
                            PlayerPose.between(before, after, 1).later());
                    assertTrue(turned <= Math.toRadians(degrees) * TICK + ROUNDING, "turned by " + turned);
                }
                assertTrue(crossed);
            }
        }
    }

    /** The faster the rate, the sooner the view is level; at every rate it finally is. */
    @Test
    void theRateSaysHowLongItTakes() {
        for (int kind = 0; kind < 3; kind++) {
            int slow = ticksLeaning(turns(rate(90)).get(kind));
            int usual = ticksLeaning(turns(rate(360)).get(kind));
            int instant = ticksLeaning(
                    turns(rate(SimSettings.INSTANT_UPRIGHT_DEGREES_PER_SECOND)).get(kind));
            assertTrue(instant <= 1, instant + " ticks");
            assertTrue(usual >= instant && slow >= usual, slow + ", " + usual + ", " + instant);
            if (usual > 4) {
                assertEquals(4.0, (double) slow / usual, 0.8);
            }
        }
    }

    private static int ticksLeaning(Lab lab) {
        int leaning = 0;
        boolean crossed = false;
        for (int tick = 0; tick < 700; tick++) {
            SimState after =
                    lab.tick(crossed ? PlayerInput.NONE : PlayerInput.FORWARD).state();
            crossed |= after.world().trace().playerCrossed().length() > 0;
            leaning += after.player().tilt().isViewLevel() ? 0 : 1;
        }
        assertTrue(lab.player().tilt().isViewLevel(), "level in the end");
        return leaning;
    }

    /**
     * While the view turns upright, a steered player accelerates in the direction of the view, or of the picture's top
     * if it looks straight down.
     */
    @Test
    void inputFollowsTheView() {
        int steered = 0;
        for (Lab lab : turns(rate(90))) {
            lab.hold(PlayerInput.FORWARD, 0.2);
            while (lab.player().tilt().isViewLevel() && lab.state().tick() < 240) {
                lab.tick(PlayerInput.FORWARD);
            }
            for (int tick = 0; tick < 20 && !lab.player().isGrounded(); tick++) {
                Vec3 before = lab.player().velocity();
                Basis view = lab.player().view();
                Vec3 after = lab.tick(PlayerInput.FORWARD).player().velocity();
                boolean crossed = lab.state().world().trace().playerCrossed().length() > 0;
                Vector3d gained = after.toVector().sub(before.toVector());
                gained.y = 0;
                Vector3d ahead = view.back().toVector().negate().add(view.up().toVector());
                assertTrue(crossed || gained.length() < 1e-9 || gained.dot(ahead) > -1e-9, gained + " and " + ahead);
                steered += !crossed && gained.length() > 1e-3 ? 1 : 0;
            }
        }
        assertTrue(steered > 10, steered + " ticks with an effect");
    }

    /** At the steepest pitch, up and down, the mouse turns the view by no more than its own turn. */
    @Test
    void nothingFlipsAtTheVertical() {
        for (Lab lab : turns(rate(360))) {
            lab.hold(PlayerInput.FORWARD, 0.5);
            for (int tick = 0; tick < 300; tick++) {
                int up = tick % 60 < 30 ? 9000 : -9000;
                SimState before = lab.state();
                SimState after = lab.tick(PlayerInput.FORWARD.turning(500, up)).state();
                double turned = angle(
                        PlayerPose.between(before, after, 0).later(),
                        PlayerPose.between(before, after, 1).later());
                assertTrue(turned <= Math.toRadians(360 * TICK + 9.5) + ROUNDING, "turned by " + turned);
            }
        }
    }

    /** A replay stores a rate that differs from the default, and omits the default: old replays stay as they are. */
    @Test
    void aReplayKeepsTheRate() {
        var recorder = new ReplayRecorder("lab.json", rate(45), null).record(PlayerInput.FORWARD);
        String text = recorder.replay().write();
        assertTrue(text.contains("\"uprightDegreesPerSecond\": 45"), text);
        byte[] utf8 = text.getBytes(java.nio.charset.StandardCharsets.UTF_8);
        assertEquals(45, Replay.read("lab.json", utf8).settings().uprightDegreesPerSecond());
        String usual = Replay.standing("lab.json", 3).write();
        assertTrue(!usual.contains("upright"), usual);
    }
}
