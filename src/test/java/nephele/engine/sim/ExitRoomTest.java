package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.WorldState.Arrival;
import org.junit.jupiter.api.Test;

/** With the assist a player that has come out of a portal is eased off walls and edges, and nobody else is. */
final class ExitRoomTest {
    private static final double RADIUS = 0.3;
    private static final Vec3 UP = new Vec3(0, 1, 0);

    /**
     * A portal ahead, z = 0; its exit at x = 10, z = 18 leads back to smaller z. Who goes in at x
     * comes out at 10 + x.
     */
    private static Course room(Assist... assists) {
        return Course.onFloor()
                .box(-20, 0, -2, 20, 6, 0)
                .box(-20, 0, 18, 20, 6, 20)
                .pair(
                        new Vec3[] {new Vec3(0, 1.05, 0), new Vec3(0, 0, 1), UP},
                        new Vec3[] {new Vec3(10, 1.05, 18), new Vec3(0, 0, -1), UP})
                .with(new SimSettings(120, List.of(assists)));
    }

    private static Course helped() {
        return room(Assist.EXIT_ROOM);
    }

    /** Walks in at x until the centre is through, and then lets go of the keys. */
    private static Course out(Course course, double x) {
        course.startAt(x, 0, 1.5).hold(PlayerInput.NONE, 1 / 120.0);
        while (course.feet().z() < 10) {
            course.hold(PlayerInput.FORWARD, 1 / 120.0);
        }
        return course;
    }

    @Test
    void whoComesOutAtAWallIsEasedOffItSlowly() {
        for (int side : new int[] {-1, 1}) {
            double wall = 10 + side * 0.61;
            Course course = out(
                    helped().box(Math.min(wall, wall + side), 0, 14, Math.max(wall, wall + side), 4, 18), side * 0.29);
            double[] before = {course.feet().x()};
            assertTrue(side * (wall - before[0]) - RADIUS < 0.03, "at the wall: " + before[0]);
            course.hold(PlayerInput.NONE, 1.5, player -> {
                double step = -side * (player.feet().x() - before[0]);
                assertTrue(step >= -1e-9 && step <= 1 / 120.0 + 1e-9, "eased by " + step);
                before[0] = player.feet().x();
            });
            assertEquals(0.2, side * (wall - course.feet().x()) - RADIUS, 0.01, "room on side " + side);
            Course alone = out(
                    room().box(Math.min(wall, wall + side), 0, 14, Math.max(wall, wall + side), 4, 18), side * 0.29);
            double there = alone.feet().x();
            assertEquals(there, alone.hold(PlayerInput.NONE, 1.5).feet().x(), 1e-9);
        }
    }

    /** The edge of a block ahead, in whose way the player stands, is passed too; no key gets the player faster. */
    @Test
    void whoComesOutAtAnEdgeIsEasedOffIt() {
        Course course = out(helped().box(10.25, 0, 15, 13, 4, 17.5), 0);
        course.hold(
                PlayerInput.FORWARD, 1, player -> assertTrue(player.velocity().length() <= 4 + 1e-9));
        assertTrue(course.feet().x() < 10.25 - RADIUS - 0.1, course.feet()::toString);
    }

    /** Never against a key, nor along it, and not back into the portal. */
    @Test
    void aKeyAgainstItWins() {
        for (int strafe : new int[] {-100, -20, 20, 100}) {
            PlayerInput input = PlayerInput.NONE.walking(0, strafe);
            List<PlayerState> with = path(helped(), input);
            List<PlayerState> without = path(room(), input);
            for (int i = 0; i < with.size(); i++) {
                assertEquals(without.get(i).feet().x(), with.get(i).feet().x(), 1e-4, "tick " + i);
            }
        }
        Course facing = out(helped().box(8, 0, 16, 12, 4, 17.6), 0);
        double z = facing.feet().z();
        facing.hold(
                PlayerInput.NONE,
                1.5,
                player -> assertTrue(player.feet().z() > 17 && player.feet().z() <= z + 1e-9, "not back"));
    }

    private static List<PlayerState> path(Course course, PlayerInput input) {
        List<PlayerState> path = new ArrayList<>();
        out(course.box(10.61, 0, 14, 12, 4, 18), 0.29).hold(input, 1, path::add);
        return path;
    }

    /**
     * The assist changes no bit of the motion of a player that has not come out of a portal, has room around it, or is too
     * fast.
     */
    @Test
    void nobodyElseIsMoved() {
        assertEquals(
                room().startAt(-19.65, 0, 5).hold(PlayerInput.NONE, 1).state().player(),
                helped().startAt(-19.65, 0, 5).hold(PlayerInput.NONE, 1).state().player());
        assertEquals(
                out(room(), 0.1).hold(PlayerInput.FORWARD, 2).state().player(),
                out(helped(), 0.1).hold(PlayerInput.FORWARD, 2).state().player());
        assertEquals(
                out(room(), 0.1).hold(PlayerInput.NONE, 2).state().player(),
                out(helped(), 0.1).hold(PlayerInput.NONE, 2).state().player());
    }

    /** Nobody is eased over an edge into a pit. */
    @Test
    void nobodyIsEasedIntoAPit() {
        Course course = new Course()
                .box(-20, -1, -2, 20, 0, 8)
                .box(9.97, -1, 8, 20, 0, 20)
                .box(-20, 0, -2, 20, 6, 0)
                .box(-20, -9, 18, 20, 6, 20)
                .box(10.31, 0, 14, 12, 4, 17.6)
                .pair(
                        new Vec3[] {new Vec3(0, 1.05, 0), new Vec3(0, 0, 1), UP},
                        new Vec3[] {new Vec3(10, 1.05, 18), new Vec3(0, 0, -1), UP})
                .with(new SimSettings(120, List.of(Assist.EXIT_ROOM)));
        out(course, 0).hold(PlayerInput.NONE, 2);
        assertEquals(0, course.feet().y(), 0.02, "stands: " + course.feet());
        assertTrue(course.feet().x() < 9.99 && course.feet().x() > 9.7, "eased to the edge: " + course.feet());
    }

    /** The mirrored room gives the mirrored easing. */
    @Test
    void theMirroredRoomGivesTheMirroredWalk() {
        List<PlayerState> one = new ArrayList<>();
        List<PlayerState> other = new ArrayList<>();
        out(helped().box(10.4, 0, 15, 13, 4, 17.5), 0.2).hold(PlayerInput.NONE, 1.2, one::add);
        out(helped().box(7, 0, 15, 9.6, 4, 17.5), -0.2).hold(PlayerInput.NONE, 1.2, other::add);
        for (int i = 0; i < one.size(); i++) {
            assertEquals(one.get(i).feet().x() - 10, 10 - other.get(i).feet().x(), 1e-6);
            assertEquals(one.get(i).feet().z(), other.get(i).feet().z(), 1e-6);
        }
    }

    @Test
    void theMemoryIsHashedWithTheAssistAlone() {
        SimState with = out(helped(), 0).state();
        assertTrue(with.world().arrival().isRecent());
        assertNotEquals(
                with.hash(), with.with(with.world().with(Arrival.NOWHERE)).hash());
        assertEquals(
                out(room(), 0).state().hash(),
                with.with(with.world().with(Arrival.NONE)).hash());
    }
}
