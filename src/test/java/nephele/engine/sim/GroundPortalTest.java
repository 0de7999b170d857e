package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import nephele.engine.level.Body;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.portal.placement.PlacementResult.Refusal;
import nephele.engine.sim.state.GunPortals.Colour;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.ViewAngles;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Portals on uneven ground behave as those on floors: the same walks over both are compared. */
@Execution(ExecutionMode.CONCURRENT)
class GroundPortalTest {
    private static final DoubleBinaryOperator FLOOR = null;

    private static double bumps(double x, double z) {
        return 0.009 * Math.sin(7 * x) * Math.cos(5 * z);
    }

    /** A hill that falls away from the portal by 4 cm at 2 m. */
    private static double hill(double x, double z) {
        return bumps(x, z) / 2 - 0.01 * (x * x + (z + 2) * (z + 2));
    }

    /** Shoots the second portal at the wall ahead and the first at the ground, 2 m before the player. */
    private static GroundCourse shot(DoubleBinaryOperator heights, Body... bodies) {
        GroundCourse course = new GroundCourse(heights, new Vec3(0, 0.1, 0), bodies);
        return course.hold(PlayerInput.NONE, 0.3)
                .press(Action.FIRE_SECOND)
                .turn(0, -40)
                .press(Action.FIRE_FIRST)
                .turn(0, 40);
    }

    private static Portal onGround(GroundCourse course) {
        Portals portals = course.state.world().portals();
        assertEquals(2, portals.size(), course.events::toString);
        return portals.portal(1);
    }

    private static List<Vec3> walk(DoubleBinaryOperator heights) {
        GroundCourse course = shot(heights);
        List<Vec3> way = new ArrayList<>();
        for (int i = 0; i < 150; i++) {
            course.tick(i < 80 ? PlayerInput.FORWARD : PlayerInput.NONE);
            way.add(course.state.player().feet());
        }
        return way;
    }

    /** The way of a fall through the portal and out of the wall is that over a floor, within the bumps' height. */
    @Test
    void aPlayerFallsThroughAsThroughAFloor() {
        List<Vec3> overFloor = walk(FLOOR);
        List<Vec3> overGround = walk(GroundPortalTest::bumps);
        int late = 0;
        int jumps = 0;
        for (int i = 0; i < overFloor.size(); i++) {
            double apart = overFloor.get(i).minus(overGround.get(i)).length();
            late += apart > 0.3 ? 1 : 0;
            jumps += i > 0 && overGround.get(i).minus(overGround.get(i - 1)).length() > 0.2 ? 1 : 0;
        }
        assertEquals(1, jumps, "one passage");
        assertTrue(late <= 6, "ticks for which one is through and the other not yet: " + late);
        assertTrue(overGround.get(149).z() < -4, overGround.get(149).toString());
    }

    /** Someone who drops beside the edge, on it or inside comes to rest as high as on a floor, or falls through. */
    @ParameterizedTest
    @ValueSource(doubles = {-0.45, -0.3, -0.2, -0.1, 0, 0.1, 0.3})
    void theEdgeCarriesAsThatOfAFloor(double beyond) {
        double[] height = new double[3];
        List<DoubleBinaryOperator> grounds = new ArrayList<>();
        grounds.add(FLOOR);
        grounds.add(GroundPortalTest::bumps);
        grounds.add(GroundPortalTest::hill);
        for (int i = 0; i < 3; i++) {
            GroundCourse course = shot(grounds.get(i));
            Portal portal = onGround(course);
            PlayerState player = course.state.player();
            Vec3 feet = portal.world(0.6 + beyond, -0.4, 0.3);
            course.state = course.state.withPlayer(
                    new PlayerState(feet, Vec3.ZERO, player.heading(), 1.65, player.stance(), Vec3.ZERO, false));
            course.hold(PlayerInput.NONE, 1.2);
            Vec3 after = course.state.player().feet();
            boolean isThrough = after.minus(portal.centre()).length() > 1.5;
            height[i] = isThrough ? -1 : portal.inFront(after.x(), after.y(), after.z());
        }
        assertEquals(height[0], height[1], 0.02);
        assertEquals(height[0], height[2], 0.02);
    }

    /** Ground around the portal that falls away steeply from just beside it. */
    private static double mesa(double x, double z) {
        return -0.4 * Math.max(0, Math.max(Math.abs(x) - 0.8, Math.abs(z + 2) - 1.6));
    }

    /** Players who reach below the portal's plane beside it stand on the ground there. */
    @Test
    void groundBesideThePortalCarries() {
        GroundCourse course = shot(GroundPortalTest::mesa);
        assertEquals(-1.8, onGround(course).centre().z(), 0.1);
        PlayerState player = course.state.player();
        for (double x : new double[] {-1, -0.95, -0.9, -0.86, 0.86, 0.9, 0.95, 1}) {
            Vec3 at = new Vec3(x, 0.1, -2);
            course.state = course.state.withPlayer(
                    new PlayerState(at, Vec3.ZERO, player.heading(), 1.65, player.stance(), Vec3.ZERO, false));
            course.hold(PlayerInput.NONE, 0.5);
            Vec3 feet = course.state.player().feet();
            assertTrue(course.state.player().isGrounded());
            assertEquals(x, feet.x(), 0.01);
            assertEquals(mesa(x, -2), feet.y(), 0.03);
        }
    }

    @Test
    void bodiesFallAndRollThrough() {
        Body ball = new Body.Sphere("ball", new Vec3(0.1, 0.2, -0.7), 0.25, 5, null, 0.6, 0);
        Body cube = new Body.Box("cube", new Vec3(0.1, 3.5, -2), new Vec3(0.5, 0.5, 0.5), 5, null, 0.6, 0);
        GroundCourse course = shot((x, z) -> bumps(x, z) + 0.1 * z, ball, cube);
        course.hold(PlayerInput.NONE, 4);
        for (int body = 0; body < 2; body++) {
            Vec3 centre = course.state.world().bodies().state(body).centre();
            assertTrue(centre.z() < -3.2 && centre.z() > -8, centre.toString());
        }
    }

    /**
     * At a grazing angle, from the side with the eye near the ground, a shot crosses the portal's plane half a metre before
     * the ground beyond it. That is no portal that stands free: what a shot meets is on the ground.
     */
    @Test
    void flatShotsOverAPortalMeetTheGround() {
        GroundCourse course = new GroundCourse(GroundPortalTest::bumps, new Vec3(0, 0.1, 4));
        course.hold(PlayerInput.NONE, 0.3)
                .press(Action.FIRE_SECOND)
                .turn(0, -15)
                .press(Action.FIRE_FIRST);
        Vec3 feet = new Vec3(8, 0, onGround(course).centre().z());
        PlayerState player = course.state.player();
        double eye = 0.15;
        int fits = 0;
        int refused = 0;
        for (double beyond = 0; beyond < 1.5; beyond += 0.02) {
            ViewAngles heading = ViewAngles.ofDegrees(90, -Math.toDegrees(Math.atan2(eye, 8.6 + beyond)));
            SimState low = course.state.withPlayer(
                    new PlayerState(feet, Vec3.ZERO, heading, eye, player.stance(), player.ground(), false));
            PlacementResult result = course.simulation.aim(low, Colour.SECOND);
            if (result instanceof PlacementResult.Refused not) {
                assertEquals(Refusal.OVERLAPS_OTHER, not.reason());
                assertEquals(course.ground(not.where()), not.where().y(), 1e-6, not.toString());
                refused++;
            } else {
                fits++;
            }
        }
        assertTrue(fits > 10 && refused > 10, fits + " " + refused);
    }

    @Test
    void aRefusalSaysWhy() {
        GroundCourse course =
                new GroundCourse((x, z) -> 0.04 * ((Math.round(5 * x) + Math.round(5 * z)) % 2), new Vec3(0, 0.1, 0));
        course.hold(PlayerInput.NONE, 0.3).turn(0, -40).press(Action.FIRE_FIRST);
        var refused = (TickEvent.PortalRefused) course.events.get(course.events.size() - 1);
        assertEquals(Refusal.NOT_FLAT, refused.reason());
        assertEquals(Colour.FIRST, refused.shot());
        assertEquals(0.02, refused.unevenMetres(), 1e-3);
    }
}
