package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.Depenetration;
import nephele.engine.collision.PortalWorld;
import nephele.engine.math.Basis;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.PortalTransform;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerDimensions.Stance;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.Tilt;
import nephele.engine.sim.state.ViewAngles;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The player near portal pairs in difficult places. */
final class PortalPlayerTest {
    private static final Vec3 UP = new Vec3(0, 1, 0);
    private static final Vec3 SOUTH = new Vec3(0, 0, 1);
    private static final Vec3 NORTH = new Vec3(0, 0, -1);
    private static final Vec3 EAST = new Vec3(1, 0, 0);

    private static Vec3[] end(double x, double y, double z, Vec3 normal, Vec3 up) {
        return new Vec3[] {new Vec3(x, y, z), normal, up};
    }

    /** The capsule is free of the solids of the opened world after every tick, and on the floor or above. */
    private static Course walkFreely(Course course, PlayerInput input, double seconds) {
        Depenetration depenetration = new Depenetration();
        PortalWorld portalWorld = PortalWorld.of(course.world(), course.portals());
        return course.hold(input, seconds, player -> {
            Vector3d centre = player.centre().toVector();
            var shape = player.stance().shape(player.tilt().up());
            var around = portalWorld.openedFor(portalWorld.active(shape, centre, new Vector3d()));
            assertTrue(depenetration.isFree(around, shape, centre), () -> "in a solid: " + player);
            assertTrue(player.centre().y() > -1e-9, () -> "below the floor: " + player);
        });
    }

    private static double horizontalSpeed(PlayerState p) {
        return Math.sqrt(p.velocity().x() * p.velocity().x()
                + p.velocity().z() * p.velocity().z());
    }

    /** A player walks into one of two adjacent portals and out of the other, with its shoulders in both. */
    @Test
    void sideBySide() {
        for (double x : new double[] {-0.6, -0.3, 0, 0.3}) {
            Course course = Course.onFloor()
                    .box(-9, 0, -1, 9, 5, 0)
                    .pair(end(-0.6, 1.05, 0, SOUTH, UP), end(0.6, 1.05, 0, SOUTH, UP))
                    .startAt(x, 0, 0.8);
            walkFreely(course, PlayerInput.FORWARD, 2);
            PlayerState end = course.state().player();
            assertTrue(horizontalSpeed(end) <= PlayerDimensions.WALK_METRES_PER_SECOND + 1e-9, "no explosion: " + end);
            if (x != 0) {
                // In at one and out of the other, looking back: it walks away to the south.
                assertTrue(end.feet().z() > 3, "through: " + end);
                assertEquals(-180_000, end.heading().yawMillidegrees());
            }
        }
    }

    /**
     * Between portals that face each other at 0.2 m a player is in both; it can stand still and walk, as it does not
     * collide with itself.
     */
    @Test
    void facingNearby() {
        Course course = new Course()
                .box(-9, -1, -9, 9, 0, 9)
                .box(-9, 0, -2, 9, 4, 0)
                .box(-9, 0, 0.2, 9, 4, 2)
                .pair(end(0, 1.05, 0, SOUTH, UP), end(0, 1.05, 0.2, NORTH, UP))
                .startAt(0, 0, 0.1);
        walkFreely(course, PlayerInput.NONE, 1);
        assertEquals(new Vec3(0, 0, 0.1), course.feet(), "stands still");
        walkFreely(course, PlayerInput.FORWARD, 2);
        PlayerState walking = course.state().player();
        assertEquals(PlayerDimensions.WALK_METRES_PER_SECOND, horizontalSpeed(walking), 1e-6, "walks round and round");
        assertEquals(0, walking.feet().y(), 1e-6);
        assertEquals(0, course.state().faults());
        walkFreely(course, PlayerInput.NONE.walking(30, 100), 2);
        assertTrue(
                horizontalSpeed(course.state().player()) <= PlayerDimensions.WALK_METRES_PER_SECOND + 1e-9,
                "energy not increased");
    }

    /** A player does not get stuck at two portals in a corner that share an edge. */
    @Test
    void cornerWithASharedEdge() {
        for (int right = -100; right <= 100; right += 50) {
            for (double x : new double[] {-0.35, -0.6, -0.9}) {
                Course course = Course.onFloor()
                        .box(-9, 0, -1, 9, 5, 0)
                        .box(0, 0, 0, 1, 5, 9)
                        .pair(end(-0.6, 1.05, 0, SOUTH, UP), end(0, 1.05, 0.6, new Vec3(-1, 0, 0), UP))
                        .startAt(x, 0, 0.5);
                walkFreely(course, PlayerInput.NONE.walking(100, right), 1.5);
                // From its last place, turned away from the nearest wall, it walks at full speed.
                walkFreely(course, PlayerInput.NONE, 0.5);
                double least = freeMetres(course);
                assertTrue(
                        least > 0.9,
                        "walks " + least + " m in half a second: "
                                + course.state().player());
            }
        }
    }

    /** Returns how far it walks in half a second in the best of eight directions, always free of solids. */
    private static double freeMetres(Course course) {
        SimState from = course.state();
        Vec3 feet = course.feet();
        double most = 0;
        for (int[] way :
                new int[][] {{100, 0}, {71, 71}, {0, 100}, {-71, 71}, {-100, 0}, {-71, -71}, {0, -100}, {71, -71}}) {
            course.set(from);
            walkFreely(course, PlayerInput.NONE.walking(way[0], way[1]), 0.5);
            most = Math.max(most, feet.toVector().distance(course.feet().toVector()));
        }
        return most;
    }

    /** A single portal, and one with its exit in a solid, are closed and solid. */
    @Test
    void closedPortalsAreSolid() {
        Course open = Course.onFloor()
                .box(-9, 0, -1, 9, 5, 0)
                .pair(end(0, 1.05, 0, SOUTH, UP), end(5, 1.05, 9, SOUTH, UP))
                .startAt(0, 0, 1);
        open.hold(PlayerInput.FORWARD, 1);
        assertTrue(open.feet().z() > 9, "through: " + open.feet());
        Course blocked = Course.onFloor()
                .box(-9, 0, -1, 9, 5, 0)
                .box(4, 0, 8, 6, 3, 9.5)
                .pair(end(0, 1.05, 0, SOUTH, UP), end(5, 1.05, 9, SOUTH, UP))
                .startAt(0, 0, 1);
        blocked.hold(PlayerInput.FORWARD, 1);
        assertEquals(0.301, blocked.feet().z(), 1e-6);
    }

    /** At 10 km from the origin a walk agrees within 1e-6 m after ten crossings. */
    @Test
    void farOutTheSame() {
        List<Course> courses = new ArrayList<>();
        for (Vec3 origin : List.of(Vec3.ZERO, new Vec3(10_000, 100, -10_000))) {
            courses.add(new Course(origin)
                    .box(-50, -1, -50, 50, 0, 50)
                    .box(-9, 0, -1, 9, 5, 0)
                    .box(-9, 0, 8, 9, 5, 9)
                    .pair(end(0, 1.05, 0, SOUTH, UP), end(0.4, 1.05, 8, NORTH, UP))
                    .startAt(0, 0, 1));
        }
        for (Course course : courses) {
            course.hold(PlayerInput.FORWARD.holding(Action.JUMP), 12);
        }
        Vec3 near = courses.get(0).feet();
        Vec3 far = courses.get(1).feet();
        assertEquals(near.x(), far.x() - 10_000, 1e-6);
        assertEquals(near.y(), far.y() - 100, 1e-6);
        assertEquals(near.z(), far.z() + 10_000, 1e-6);
    }

    /** A velocity that is not finite stops the player and is reported, near a portal too. */
    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, 1e308})
    void brokenVelocitiesStop(double speed) {
        Course course = Course.onFloor()
                .box(-9, 0, -1, 9, 5, 0)
                .pair(end(0, 1.05, 0, SOUTH, UP), end(5, 0, 5, UP, NORTH))
                .startAt(0, 0, 0.5);
        SimState state = course.state();
        course.set(state.withPlayer(state.player().withVelocity(new Vec3(0, 0, -speed))));
        course.hold(PlayerInput.NONE, 0.1);
        assertTrue(course.state().player().isFinite(), () -> course.state().toString());
        assertTrue(course.state().faults() > 0);
    }

    /** A portal maps the view exactly; body and view are upright again later, without a jump in between. */
    @ParameterizedTest
    @ValueSource(ints = {-80, -30, 0, 45, 89})
    void theViewIsMappedAndThenTurnsUpright(int pitch) {
        Course course = Course.onFloor()
                .box(-9, 0, -1, 9, 5, 0)
                .pair(end(0, 1.05, 0, SOUTH, UP), end(5, 0, 5, UP, new Vec3(0.6, 0, 0.8)))
                .startAt(0, 0, 0.4);
        SimState state = course.state();
        PlayerState player = state.player();
        course.set(state.withPlayer(new PlayerState(
                player.feet(),
                new Vec3(0, 0, -4),
                new ViewAngles(7_654, pitch * 1000),
                player.eyeMetres(),
                player.stance(),
                null,
                false)));
        Basis[] last = {view(course.state().player())};
        Vec3[] lastUp = {UP};
        int[] crossed = {0};
        course.hold(PlayerInput.FORWARD, 3, now -> {
            Basis view = view(now);
            CrossingWord word = course.state().world().trace().playerCrossed();
            if (word.length() == 1) {
                crossed[0]++;
                PortalTransform transform = course.portals().transform(word.entry(0));
                assertEquals(0, Directions.angle(transform.direction(last[0].back()), view.back()), 1e-12);
                assertEquals(0, Directions.angle(transform.direction(last[0].up()), view.up()), 1e-12);
                Vec3 body = transform.direction(lastUp[0]);
                assertEquals(0, Directions.angle(body, now.tilt().up()), 1e-12);
            } else {
                double most = 2 * Math.PI / 120 + 1e-9;
                assertTrue(Directions.angle(last[0].back(), view.back()) <= most, "the view jumps: " + now);
                assertTrue(Directions.angle(last[0].up(), view.up()) <= most, "the view jumps: " + now);
            }
            last[0] = view;
            lastUp[0] = now.tilt().up();
        });
        assertTrue(crossed[0] > 0, "crosses");
        assertEquals(Tilt.UPRIGHT, course.state().player().tilt(), "upright in the end");
        assertTrue(course.state().player().isGrounded());
    }

    private static Basis view(PlayerState player) {
        return player.view();
    }

    /** A tilted body without head room stays tilted, and turns upright in the open. */
    @Test
    void turnsAsRoomAllows() {
        Course course = Course.onFloor().box(-3, 0.8, -3, 3, 1, 3).startAt(0, 0, 0);
        Tilt lying = Tilt.of(EAST, new org.joml.Quaterniond());
        double feet = PlayerDimensions.RADIUS_METRES + 0.001 - Stance.STANDING.centreAboveFeet();
        SimState state = course.state();
        PlayerState player = new PlayerState(
                new Vec3(0, feet, 0), Vec3.ZERO, new ViewAngles(0, 0), 1.65, Stance.STANDING, null, false, lying);
        course.set(state.withPlayer(player));
        walkFreely(course, PlayerInput.NONE, 1);
        PlayerState under = course.state().player();
        assertTrue(under.tilt().up().y() < 0.6, "no room to stand: " + under);
        walkFreely(course, PlayerInput.FORWARD, 2);
        PlayerState out = course.state().player();
        assertEquals(Tilt.UPRIGHT, out.tilt());
        assertEquals(0, out.feet().y(), 1e-6);
        assertTrue(out.isGrounded());
    }
}
