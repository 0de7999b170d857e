package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.ViewAngles;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Endless falls of the player keep speed, height and lateral motion at every tick rate. */
final class PortalLoopTest {
    private static final Vec3 UP = new Vec3(0, 1, 0);
    private static final Vec3 DOWN = new Vec3(0, -1, 0);
    private static final Vec3 NORTH = new Vec3(0, 0, -1);
    private static final double G = PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED;

    private static double speedSquared(PlayerState p) {
        Vec3 v = p.velocity();
        return v.x() * v.x() + v.y() * v.y() + v.z() * v.z();
    }

    /** Returns twice the energy of the capsule's centre per unit of mass. */
    private static double energy(PlayerState p, double level) {
        return speedSquared(p) + 2 * G * (p.centre().y() - level);
    }

    /**
     * A player that falls from 2 m above one floor portal comes out of the other and back at the same height, at every
     * rate.
     */
    @ParameterizedTest
    @ValueSource(ints = {30, 60, 120, 240})
    void floorToFloorKeepsItsHeight(int rate) {
        Course course = Course.onFloor()
                .pair(new Vec3[] {new Vec3(-3, 0, 0), UP, NORTH}, new Vec3[] {new Vec3(3, 0, 0), UP, NORTH})
                .startAt(-3, 2 - PlayerDimensions.Stance.STANDING.centreAboveFeet(), 0)
                .ticksPerSecond(rate);
        int[] passes = new int[1];
        double[] side = {-1};
        double whole = 2 * G * 2;
        course.hold(PlayerInput.NONE, 100 * 1.2772, player -> {
            assertEquals(whole, energy(player, 0), 2 * G * 1e-6, "after " + passes[0] + " passes");
            double now = Math.signum(player.feet().x());
            passes[0] += now == side[0] ? 0 : 1;
            side[0] = now;
            assertEquals(3, Math.abs(player.feet().x()), 1e-6);
        });
        assertTrue(passes[0] >= 98, "passes " + passes[0]);
        assertEquals(0, course.state().faults());
    }

    /** After k passes of H metres v² = 2 g H k within 1e-9, as long as a tick has at most eight crossings. */
    @Test
    void floorToCeilingGainsWhatItFalls() {
        Course course = Course.onFloor()
                .box(-50, 3, -50, 50, 4, 50)
                .pair(new Vec3[] {new Vec3(0, 0, 0), UP, NORTH}, new Vec3[] {new Vec3(0, 3, 0), DOWN, NORTH})
                .startAt(0, 0.5, 0);
        double start = course.state().player().centre().y();
        double[] fallen = {start};
        double seconds = 248;
        course.hold(PlayerInput.NONE, seconds, player -> {});
        PlayerState end = course.state().player();
        double distance = G * seconds * seconds / 2;
        long passes = Math.round((distance - (fallen[0] - end.centre().y())) / 3);
        double expected = 2 * G * (passes * 3 + start - end.centre().y());
        assertEquals(1, speedSquared(end) / expected, 1e-9, "after " + passes + " passes");
        assertTrue(passes > 100_000, "passes " + passes);
        assertEquals(0, course.state().faults());
    }

    /** With more than eight crossings in a tick the rest of the tick is dropped and reported; the speed stays. */
    @Test
    void dropsTimeAtTooManyHops() {
        Course course = Course.onFloor()
                .box(-50, 3, -50, 50, 4, 50)
                .pair(new Vec3[] {new Vec3(0, 0, 0), UP, NORTH}, new Vec3[] {new Vec3(0, 3, 0), DOWN, NORTH})
                .startAt(0, 0.5, 0)
                .ticksPerSecond(30);
        SimState state = course.state();
        course.set(state.withPlayer(state.player().withVelocity(new Vec3(0, -5000, 0))));
        course.hold(PlayerInput.NONE, 1);
        assertEquals(30, course.state().faults());
        assertEquals(5000, Math.abs(course.state().player().velocity().y()), 10);
        assertEquals(0, course.state().player().feet().x(), 1e-9);
    }

    /** An oblique endless fall keeps its lateral speed until it touches the rim. */
    @Test
    void sidewaysSpeedIsKept() {
        Course course = Course.onFloor()
                .box(-50, 3, -50, 50, 4, 50)
                .pair(new Vec3[] {new Vec3(0, 0, 0), UP, NORTH}, new Vec3[] {new Vec3(0, 3, 0), DOWN, NORTH})
                .startAt(0, 0.5, 0.5);
        SimState state = course.state();
        course.set(state.withPlayer(state.player().withVelocity(new Vec3(0.002, 0, -0.01))));
        course.hold(PlayerInput.NONE, 60);
        PlayerState end = course.state().player();
        assertEquals(0.002, end.velocity().x(), 1e-12);
        assertEquals(-0.01, end.velocity().z(), 1e-12);
        assertEquals(0.12, end.feet().x(), 1e-9);
        assertEquals(-0.1, end.feet().z(), 1e-9);
    }

    /** For each speed the exit is the same at every tick rate. */
    @ParameterizedTest
    @ValueSource(doubles = {0.001, 0.1, 10, 1000})
    void exitsAlikeAtEveryRate(double speed) {
        Vec3 first = null;
        for (int rate : new int[] {30, 60, 120, 240}) {
            Course course = new Course()
                    .box(-5000, -5000, -1, 5000, 5000, 0)
                    .pair(
                            new Vec3[] {new Vec3(0, 0, 0), new Vec3(0, 0, 1), UP},
                            new Vec3[] {new Vec3(100, 30, 50), new Vec3(1, 0, 0), UP})
                    .startAt(0, -PlayerDimensions.Stance.STANDING.centreAboveFeet(), 1e-3 * Math.min(speed, 1))
                    .ticksPerSecond(rate);
            SimState state = course.state();
            course.set(state.withPlayer(state.player().withVelocity(new Vec3(0, 0, -speed))));
            course.hold(PlayerInput.NONE, 0.1);
            Vec3 feet = course.feet();
            assertEquals(ViewAngles.ofDegrees(-90, 0), course.state().player().heading());
            first = first == null ? feet : first;
            assertEquals(first.x(), feet.x(), 1e-3);
            assertEquals(first.y(), feet.y(), 1e-3);
            assertEquals(first.z(), feet.z(), 1e-3);
            assertTrue(feet.x() > 100 && feet.z() == 50, "crossed once: " + feet);
        }
    }
}
