package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * With the assist a walker goes into a portal beside or before it, if its move intent points there, and nobody else is
 * moved.
 */
final class WalkInTest {
    private static final List<PlayerInput> GAITS = List.of(
            PlayerInput.FORWARD, PlayerInput.FORWARD.holding(Action.RUN), PlayerInput.FORWARD.holding(Action.CROUCH));
    private static final double TRIM = 0.05;

    private static SimSettings settings(Assist... assists) {
        return new SimSettings(120, List.of(assists));
    }

    /** A portal in the wall ahead, z = 0, with its middle at x = 0 and its lower edge on the floor. */
    private static Course room(PortalShape shape) {
        return room(shape, 0);
    }

    private static Course room(PortalShape shape, double sill) {
        Vec3 up = new Vec3(0, 1, 0);
        return Course.onFloor()
                .box(-20, 0, -2, 20, 6, 0)
                .box(-20, 0, 18, 20, 6, 20)
                .pair(
                        new Vec3[] {new Vec3(0, 1.05 + sill, 0), new Vec3(0, 0, 1), up},
                        new Vec3[] {new Vec3(10, 1.05 + sill, 18), new Vec3(0, 0, -1), up},
                        Aperture.of(shape, 1.2, 2.1))
                .with(settings(Assist.WALK_IN));
    }

    /** A frame of trims around the portal that also cover a part of it, and a sill. */
    private static Course framed(PortalShape shape) {
        return room(shape)
                .box(-0.65, 0, 0, -0.55, 2.2, TRIM)
                .box(0.55, 0, 0, 0.65, 2.2, TRIM)
                .box(-0.55, 0, 0, 0.55, TRIM, TRIM)
                .box(-0.65, 2.08, 0, 0.65, 2.2, TRIM);
    }

    /** Returns true if a walker goes through; its yaw is that of its way, 0 straight ahead and positive to the left. */
    private static boolean goesThrough(Course course, double x, double z, double yawDegrees, PlayerInput gait) {
        course.startAt(x, 0, z);
        course.hold(PlayerInput.NONE.turning((int) Math.round(1000 * yawDegrees), 0), 1 / 120.0);
        boolean[] through = new boolean[1];
        for (int i = 0; i < 60 && !through[0]; i++) {
            course.hold(gait, 0.1, player -> through[0] |= player.feet().z() > 15);
        }
        return through[0];
    }

    @Test
    void fromEveryDistanceAndSideAWalkerAtTheMiddleGoesIn() {
        for (double metres : new double[] {0.5, 2}) {
            for (int degrees = -80; degrees <= 80; degrees += 20) {
                for (PlayerInput gait : GAITS) {
                    double radians = Math.toRadians(degrees);
                    double x = metres * StrictMath.sin(radians);
                    double z = Math.max(0.302, metres * StrictMath.cos(radians));
                    double yaw = Math.toDegrees(StrictMath.atan2(x, z));
                    String who = gait + " from " + metres + " m at " + degrees;
                    assertTrue(goesThrough(room(PortalShape.ARCH), x, z, yaw, gait), who);
                }
            }
        }
        Course alone = room(PortalShape.ARCH).with(settings());
        assertFalse(goesThrough(alone, 2, 0.4, 80, PlayerInput.FORWARD), "without the assist");
    }

    /** Along the wall, from 10° towards it, also around trims of 5 cm and over a sill of 5 cm. */
    @ParameterizedTest
    @EnumSource(PortalShape.class)
    void alongTheWallAWalkerGoesInAroundFramesAndSills(PortalShape shape) {
        for (int side : new int[] {-1, 1}) {
            for (int degrees : new int[] {10, 30, 85}) {
                for (PlayerInput gait : degrees == 10 ? GAITS : GAITS.subList(0, 1)) {
                    double x = side * (degrees > 45 ? 0.95 : 2.5);
                    double yaw = side * (90 - degrees);
                    String who = gait + " at " + degrees + " on side " + side;
                    assertTrue(goesThrough(room(shape), x, 0.4, yaw, gait), who);
                    assertTrue(goesThrough(framed(shape), x, 0.4, yaw, gait), who + ", framed");
                }
            }
        }
    }

    /** The edge of a round frame and a sill are ground on two sides, and no trap between them. */
    @Test
    void betweenARoundFrameAndASillNobodyIsCaught() {
        for (int degrees : new int[] {10, 30, 60}) {
            Course course = room(PortalShape.ELLIPSE, TRIM)
                    .box(-0.65, 0, 0, 0.65, TRIM, TRIM)
                    .box(9.35, 0, 18 - TRIM, 10.65, TRIM, 18);
            assertTrue(goesThrough(course, 1, 0.302, 90 - degrees, GAITS.get(2)), "at " + degrees);
        }
    }

    /** The assist changes no bit of a walk whose intent does not point into the portal, or that is past the opening. */
    @Test
    void withoutIntentIntoThePlaneNothingChanges() {
        PlayerInput right = PlayerInput.NONE.walking(0, 100);
        PlayerInput back = PlayerInput.NONE.walking(-100, 0);
        assertUntouched(-2, 0.4, 0, right, "along the wall");
        assertUntouched(-2, 0.4, -5, right, "at 5°");
        assertUntouched(0.2, 0.35, 0, back, "away from it");
        assertUntouched(0.2, 0.35, 0, PlayerInput.NONE.walking(-20, 100), "away and along");
        assertUntouched(0.65, 0.302, -15, right, "past it");
        assertUntouched(0, 1.5, 0, PlayerInput.FORWARD, "straight in");
        assertUntouched(0.1, 0.302, 0, PlayerInput.NONE, "at rest");
    }

    private static void assertUntouched(double x, double z, double yawDegrees, PlayerInput input, String who) {
        assertEquals(
                path(room(PortalShape.ARCH).with(settings()), x, z, yawDegrees, input),
                path(room(PortalShape.ARCH), x, z, yawDegrees, input),
                who);
    }

    private static List<PlayerState> path(Course course, double x, double z, double yawDegrees, PlayerInput input) {
        List<PlayerState> path = new ArrayList<>();
        course.startAt(x, 0, z);
        course.hold(PlayerInput.NONE.turning((int) Math.round(1000 * yawDegrees), 0), 1 / 120.0);
        course.hold(input, 1.5, path::add).hold(PlayerInput.NONE, 0.5, path::add);
        return path;
    }

    /** A walker that lets go of the keys before the opening comes to rest as without the assist. */
    @Test
    void momentumAloneLeadsNowhere() {
        for (PlayerInput released : List.of(PlayerInput.NONE, PlayerInput.NONE.walking(-100, 0))) {
            Course helped = room(PortalShape.ARCH);
            Course alone = room(PortalShape.ARCH).with(settings());
            for (Course course : List.of(helped, alone)) {
                course.startAt(-1.5, 0, 0.302).hold(PlayerInput.NONE.walking(0, 100), 0.3);
                course.hold(released, 1);
            }
            assertEquals(alone.state().player(), helped.state().player());
        }
    }

    /** In the mirrored room the mirrored walk leads through the mirrored places, and nobody gets faster than its gait. */
    @Test
    void theMirroredWalkIsTheMirrorOfTheWalk() {
        for (int degrees : new int[] {10, 25, 60, 80}) {
            for (boolean hasFrame : new boolean[] {false, true}) {
                List<PlayerState> one = walk(hasFrame, 1, degrees);
                List<PlayerState> other = walk(hasFrame, -1, degrees);
                for (int i = 0; i < one.size(); i++) {
                    Vec3 a = one.get(i).feet();
                    Vec3 b = other.get(i).feet();
                    if (a.z() > 10 || b.z() > 10) {
                        break;
                    }
                    assertEquals(a.x(), -b.x(), 1e-4, "tick " + i + " at " + degrees);
                    assertEquals(a.z(), b.z(), 1e-4, "tick " + i + " at " + degrees);
                    assertTrue(one.get(i).velocity().length() <= 4 + 1e-9);
                }
            }
        }
    }

    private static List<PlayerState> walk(boolean hasFrame, int side, int degrees) {
        Course course = hasFrame ? framed(PortalShape.ARCH) : room(PortalShape.ARCH);
        List<PlayerState> path = new ArrayList<>();
        course.startAt(side * 1.2, 0, 0.5);
        course.hold(PlayerInput.NONE.turning(side * 1000 * (90 - degrees), 0), 1 / 120.0);
        course.hold(PlayerInput.FORWARD, 1, path::add);
        return path;
    }

    /** The portal beside a corner, and one whose exit is in a corner, are entered from every side that there is. */
    @Test
    void cornersBesideAPortalStopNobody() {
        for (int degrees = -10; degrees <= 80; degrees += 15) {
            double radians = Math.toRadians(degrees);
            double x = StrictMath.sin(radians);
            double z = Math.max(0.302, StrictMath.cos(radians));
            double yaw = Math.toDegrees(StrictMath.atan2(x, z));
            Course entry = room(PortalShape.RECTANGLE).box(-2, 0, 0, -0.61, 4, 4);
            assertTrue(goesThrough(entry, x, z, yaw, PlayerInput.FORWARD), "corner at the entry, " + degrees);
            Course exit = room(PortalShape.RECTANGLE).box(10.61, 0, 14, 12, 4, 18);
            assertTrue(goesThrough(exit, x, z, yaw, PlayerInput.FORWARD), "corner at the exit, " + degrees);
        }
    }

    /** A cube pushed ahead, and one carried, goes through with the walker. */
    @Test
    void pushedAndCarriedBodiesGoThroughToo() {
        for (int degrees : new int[] {-70, 40}) {
            double radians = Math.toRadians(degrees);
            Vec3 from = new Vec3(3 * StrictMath.sin(radians), 0, -8 + 3 * StrictMath.cos(radians));
            Vec3 cube = new Vec3(from.x() * 0.6, 0.2, -8 + (from.z() + 8) * 0.6);
            for (boolean carries : new boolean[] {false, true}) {
                Lab lab = Lab.hall()
                        .pair(new Vec3(0, 1.05, -8), new Vec3(0, 0, 1), new Vec3(-8, 1.05, 3), new Vec3(1, 0, 0))
                        .cube(cube, 0.4, 10)
                        .startAt(from.x(), 0, from.z(), degrees, -50)
                        .with(settings(Assist.WALK_IN))
                        .hold(PlayerInput.NONE, 0.1);
                if (carries) {
                    lab.press(Action.CARRY).turn(0, 50).hold(PlayerInput.NONE, 0.3);
                    assertTrue(lab.holding().isHolding());
                }
                boolean[] through = new boolean[1];
                lab.hold(
                        PlayerInput.FORWARD,
                        4,
                        state -> through[0] |=
                                state.world().trace().playerCrossed().length() > 0);
                assertTrue(through[0], "at " + degrees + (carries ? " carrying " : " pushing ") + lab.player());
            }
        }
    }
}
