package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.Depenetration;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.level.Body;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portal;
import nephele.engine.portal.ground.GroundSeat;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.ViewAngles;
import org.joml.Vector3d;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Players and bodies pass portals on bumpy slopes: once, without a jump, above the ground, and free afterwards. */
@Execution(ExecutionMode.CONCURRENT)
class SlopePortalTest {
    private static final double SECONDS = 1.0 / 120;

    /** Greatest motion of eye and view within a tick: that of the turn to upright. */
    private static final double TURNED_METRES = 0.1;

    private static final double TURNED_RADIANS = 2 * Math.PI * SECONDS + 1e-3;

    /** Time after a passage in which another one counts as going back and forth. */
    private static final int FLICKER_TICKS = 30;

    private static final double GROUND_METRES = 0.02;

    /** Least depth in a solid that counts. */
    private static final double DEEP_METRES = 1e-3;

    /** A walk of which every tick is checked. */
    private static final class Walk {
        final PortalValley valley;
        final List<Integer> passages = new ArrayList<>();
        private final PortalWorld space;
        private final Depenetration solids = new Depenetration();
        private int ticks;

        Walk(PortalValley valley) {
            this.valley = valley;
            space = valley.space();
        }

        PlayerState player() {
            return valley.state.player();
        }

        Walk put(Vec3 feet, double yawDegrees) {
            PlayerState before = player();
            ViewAngles heading = ViewAngles.ofDegrees(yawDegrees, 0);
            valley.state = valley.state.withPlayer(
                    new PlayerState(feet, Vec3.ZERO, heading, before.eyeMetres(), before.stance(), null, false));
            return this;
        }

        Walk hold(PlayerInput input, double seconds) {
            for (int i = 0; i < seconds / SECONDS; i++) {
                PlayerState before = player();
                valley.tick(input);
                ticks++;
                CrossingWord crossed = valley.state.world().trace().playerCrossed();
                if (crossed.length() > 0) {
                    assertEquals(1, crossed.length(), "portals in a tick");
                    assertTrue(
                            passages.isEmpty() || ticks - passages.get(passages.size() - 1) > FLICKER_TICKS,
                            () -> "back and forth at tick " + ticks + " after " + passages);
                    passages.add(ticks);
                }
                assertContinuous(before, crossed);
                assertInTheOpen();
            }
            return this;
        }

        /** Holds until the first passage, and a little longer. */
        Walk through(PlayerInput input, double mostSeconds) {
            for (int i = 0; i < mostSeconds / SECONDS && passages.isEmpty(); i++) {
                hold(input, SECONDS / 2);
            }
            assertEquals(1, passages.size(), () -> "a passage; the player is at " + player());
            return this;
        }

        private void assertContinuous(PlayerState before, CrossingWord crossed) {
            Vector3d eye = before.eye(new Vector3d());
            Vector3d ahead = before.ahead(new Vector3d());
            for (int i = 0; i < crossed.length(); i++) {
                var transform = valley.state.world().portals().transform(crossed.entry(i));
                transform.point(eye);
                transform.direction(ahead);
            }
            PlayerState now = player();
            double most = (before.velocity().length() + now.velocity().length()) * SECONDS + TURNED_METRES;
            double jump = eye.distance(now.eye(new Vector3d()));
            assertTrue(jump <= most, () -> "the eye jumps by " + jump + " at " + now);
            double turn = Directions.angle(Vec3.of(ahead), Vec3.of(now.ahead(new Vector3d())));
            assertTrue(turn <= TURNED_RADIANS, () -> "the view turns by " + turn + " at " + now);
        }

        private void assertInTheOpen() {
            PlayerState now = player();
            Vec3 centre = now.centre();
            assertTrue(centre.y() > valley.ground(centre), () -> "below the ground: " + now);
            var shape = now.stance().shape(now.tilt().up());
            Vector3d at = centre.toVector();
            double deep = solids.depth(space.openedFor(space.active(shape, at, new Vector3d())), shape, at);
            // Ground lies up to twice the unevenness behind its portal's plane, where a leg may be that came through.
            boolean isThrough = !passages.isEmpty() && ticks - passages.get(passages.size() - 1) <= 1;
            double most = isThrough ? 2 * GroundSeat.MOST_UNEVEN_METRES : DEEP_METRES;
            assertTrue(deep <= most, () -> "in a solid by " + deep + ": " + now);
        }

        /** The player rests on the ground after one passage, and walks off in the best of eight directions. */
        void assertArrivedOnceAndFree() {
            hold(PlayerInput.NONE, 1.5);
            assertEquals(1, passages.size(), passages::toString);
            assertFree();
        }

        void assertFree() {
            PlayerState rest = player();
            assertTrue(rest.isGrounded(), () -> "rests: " + rest);
            SimState from = valley.state;
            double most = 0;
            for (int[] way :
                    new int[][] {{100, 0}, {71, 71}, {0, 100}, {-71, 71}, {-100, 0}, {-71, -71}, {0, -100}, {71, -71}
                    }) {
                valley.state = from;
                passages.clear();
                hold(PlayerInput.NONE.walking(way[0], way[1]), 0.4);
                most = Math.max(most, player().feet().minus(rest.feet()).length());
            }
            double metres = most;
            assertTrue(metres > 0.8, () -> "walks " + metres + " m from " + rest);
            valley.state = from;
        }
    }

    private static PortalValley valley(double degrees, Body... bodies) {
        return new PortalValley(degrees, degrees, List.of(), bodies);
    }

    /** The player walks in uphill over the near edge, or downhill over the far one, and comes out of a wall. */
    @ParameterizedTest
    @CsvSource({"10, 0", "20, 0", "30, 0", "40, 0", "45, 0", "10, 180", "20, 180", "30, 180", "40, 180", "45, 180"})
    void aPlayerWalksIntoTheSlopeAndOutOfAWall(double degrees, double yaw) {
        PortalValley valley = valley(degrees);
        Portal north = valley.north();
        valley.open(north, valley.wall());
        Walk walk = new Walk(valley);
        Vec3 before = north.centre().plus(new Vec3(0.1, 0, yaw == 0 ? 2.6 : -2.6));
        walk.put(new Vec3(before.x(), valley.ground(before) + 0.3, before.z()), yaw);
        // Downhill at full speed one leaps over the portal of a steep slope, as over a hole.
        PlayerInput input = yaw == 0 ? PlayerInput.FORWARD : PlayerInput.NONE.walking(30, 0);
        walk.hold(PlayerInput.NONE, 0.4).through(input, 4).hold(PlayerInput.NONE, 0.8);
        assertTrue(walk.player().feet().x() < -4, () -> walk.player().toString());
        walk.assertArrivedOnceAndFree();
    }

    /**
     * From 3 m above, at five places of the aperture. Where the floor beyond is walkable as seen from here, one may come
     * to rest on it with the legs through, and walks on from there.
     */
    @ParameterizedTest
    @ValueSource(doubles = {10, 20, 30, 45, 60})
    void aPlayerFallsIntoTheSlopeAndOutOfAWall(double degrees) {
        fallIntoTheSlope(degrees, -5);
    }

    /** The portal lies just below a crest, beyond which the ground falls away from its plane. */
    @ParameterizedTest
    @ValueSource(doubles = {20, 30, 45})
    void aPlayerFallsIntoTheSlopeBelowItsCrest(double degrees) {
        fallIntoTheSlope(degrees, -11.9);
    }

    private static void fallIntoTheSlope(double degrees, double z) {
        for (double[] place : new double[][] {{0, 0}, {0.2, 0.5}, {-0.2, -0.6}, {0, -0.3}, {-0.1, 0.3}}) {
            PortalValley valley = valley(degrees);
            Portal north = valley.north(z);
            valley.open(north, valley.wall());
            Walk walk = new Walk(valley);
            walk.put(north.world(place[0], place[1], 0).plus(new Vec3(0, 3, 0)), 0);
            walk.hold(PlayerInput.NONE, 2);
            if (walk.passages.isEmpty()) {
                walk.through(PlayerInput.FORWARD, 1);
            }
            walk.assertArrivedOnceAndFree();
        }
    }

    /** The player comes out of a slope of 20 or 45 degrees. One that falls back passes again, after it has left the portal. */
    @ParameterizedTest
    @CsvSource({"10, 20", "20, 45", "30, 20", "45, 45", "45, 10"})
    void aPlayerFallsIntoASlopeAndOutOfAnother(double into, double out) {
        PortalValley valley = new PortalValley(into, out, List.of());
        Portal north = valley.north();
        valley.open(north, valley.south());
        Walk walk = new Walk(valley);
        walk.put(north.centre().plus(new Vec3(0, 2, 0)), 0).through(PlayerInput.NONE, 2);
        assertEquals(5, walk.player().centre().z(), 1.5);
        walk.hold(PlayerInput.NONE.walking(0, 100), 2.5).hold(PlayerInput.NONE, 1.5);
        walk.assertFree();
    }

    /** The least speed of floor exits lifts the player out of slopes up to 45 degrees. */
    @ParameterizedTest
    @ValueSource(doubles = {10, 20, 30, 40, 45})
    void aPlayerWalksIntoAWallAndOutOfTheSlope(double degrees) {
        PortalValley valley = new PortalValley(degrees, degrees, List.of(Assist.FLOOR_EXIT_SPEED));
        valley.open(valley.wall(), valley.north());
        Walk walk = new Walk(valley);
        walk.put(new Vec3(-6.5, valley.ground(new Vec3(-6.5, 0, 0)) + 0.1, 0), 90);
        walk.hold(PlayerInput.NONE, 0.3).through(PlayerInput.FORWARD, 2);
        walk.hold(PlayerInput.NONE.walking(0, 100), 1.6);
        walk.assertArrivedOnceAndFree();
    }

    /** A cube that falls into the slope, and a smooth one that slides into it from above, if it is steep enough. */
    @ParameterizedTest
    @ValueSource(doubles = {10, 20, 30, 45})
    void cubesPassOnce(double degrees) {
        double up = Math.tan(Math.toRadians(degrees));
        Body falls = new Body.Box("falls", new Vec3(0, 3 * up + 2.5, -5), cube(0.5), 20, null, 0.6, 0);
        Body slides = new Body.Box("slides", new Vec3(0.1, 4.2 * up + 0.6, -6.2), cube(0.4), 20, null, 0.05, 0);
        PortalValley valley = valley(degrees, falls, slides);
        valley.open(valley.north(), valley.wall());
        int[] passed = new int[2];
        int[] last = {-100, -100};
        for (int tick = 0; tick < 120 * 6; tick++) {
            BodyState[] before = {body(valley, 0), body(valley, 1)};
            valley.tick(PlayerInput.NONE);
            for (int i = 0; i < 2; i++) {
                BodyState now = body(valley, i);
                assertTrue(now.centre().y() > valley.ground(now.centre()), i + " is below the ground: " + now);
                double most = (before[i].velocity().length() + now.velocity().length()) * SECONDS + 0.02;
                if (now.centre().minus(before[i].centre()).length() > most) {
                    assertTrue(tick - last[i] > FLICKER_TICKS, i + " goes back and forth at tick " + tick);
                    last[i] = tick;
                    passed[i]++;
                }
            }
        }
        for (int i = 0; i < (degrees > 10 ? 2 : 1); i++) {
            assertEquals(1, passed[i], i + " passed: " + body(valley, i));
            assertTrue(body(valley, i).velocity().length() < 0.1, i + " rests: " + body(valley, i));
            assertLiesOnTheGround(valley, body(valley, i), i == 0 ? 0.5 : 0.4);
        }
    }

    private static Vec3 cube(double edge) {
        return new Vec3(edge, edge, edge);
    }

    private static BodyState body(PortalValley valley, int body) {
        return valley.state.world().bodies().state(body);
    }

    private static void assertLiesOnTheGround(PortalValley valley, BodyState body, double edge) {
        double least = Double.POSITIVE_INFINITY;
        for (int corner = 0; corner < 8; corner++) {
            Vector3d at = new Vector3d((corner & 1) - 0.5, (corner >> 1 & 1) - 0.5, (corner >> 2) - 0.5).mul(edge);
            Vec3 place = Vec3.of(body.orientation().transform(at)).plus(body.centre());
            least = Math.min(least, place.y() - valley.ground(place));
        }
        assertEquals(0, least, GROUND_METRES, body.toString());
    }
}
