package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.PlayerState;
import nephele.workshop.prove.geometry.BruteForce;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Scenarios of a player on foot. Forward is −z. */
class PlayerMotionTest {
    private static final PlayerInput FORWARD = PlayerInput.FORWARD;
    private static final PlayerInput RUN = FORWARD.holding(Action.RUN);
    private static final PlayerInput JUMP = FORWARD.holding(Action.JUMP);
    private static final PlayerInput CROUCHED = FORWARD.holding(Action.CROUCH);

    private static Course stairs(double rise, int steps) {
        Course course = Course.onFloor();
        for (int i = 0; i < steps; i++) {
            course.box(-2, 0, -40, 2, rise * (i + 1), -2 - 0.3 * i);
        }
        return course;
    }

    private static void assertGrounded(PlayerState player) {
        assertTrue(player.isGrounded(), () -> "in the air at " + player.feet());
    }

    @Test
    void walksAtWalkingSpeedAndRunsAtRunningSpeed() {
        Course walk = Course.onFloor().hold(FORWARD, 2);
        double from = walk.feet().z();
        assertEquals(-4, walk.hold(FORWARD, 1).feet().z() - from, 1e-6);
        Course run = Course.onFloor().hold(RUN, 2);
        from = run.feet().z();
        assertEquals(-6, run.hold(RUN, 1).feet().z() - from, 1e-6);
    }

    @Test
    void restingKeepsTheVeryBitsOfThePose() {
        Course course = Course.onFloor().hold(RUN, 0.5).hold(PlayerInput.NONE, 3);
        PlayerState resting = course.state().player();
        course.hold(PlayerInput.NONE, 10, player -> assertEquals(resting, player));
        assertEquals(0, resting.feet().y(), 1e-7);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.2, 0.3, 0.4})
    void climbsStairsWithoutLeavingTheGround(double rise) {
        Course course = stairs(rise, 10).hold(FORWARD, 0.2);
        double[] lastZ = {course.feet().z()};
        course.hold(FORWARD, 2, player -> {
            assertGrounded(player);
            assertTrue(player.feet().z() < lastZ[0] - 0.02, () -> "held up at " + player.feet());
            lastZ[0] = player.feet().z();
        });
        assertEquals(10 * rise, course.feet().y(), 1e-6);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.2, 0.3, 0.4})
    void runsDownStairsWithoutLeavingTheGround(double rise) {
        Course course = Course.onFloor();
        for (int i = 0; i < 10; i++) {
            course.box(-2, 0, -2 - 0.3 * i, 2, rise * (10 - i), 10);
        }
        course.startAt(0, 10 * rise, 0).hold(PlayerInput.NONE, 0.1);
        course.hold(RUN, 2, PlayerMotionTest::assertGrounded);
        assertEquals(0, course.feet().y(), 1e-6);
        assertTrue(course.feet().z() < -8);
    }

    /**
     * On stairs the eye rises in a tick by less than 1.5 times as much as on a ramp of the same slope, although the
     * feet jump from tread to tread.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0.15, 0.3, 0.4})
    void theEyeGlidesOverStairs(double rise) {
        Course course = stairs(rise, 8);
        double rampPerTick = rise / 0.3 * 6 / 120;
        double[] eye = {1.65};
        course.hold(RUN, 3, player -> {
            double now = player.feet().y() + player.eyeMetres();
            double rose = now - eye[0];
            assertTrue(rose > -1e-9 && rose < 1.5 * rampPerTick, () -> "the eye jumped by " + rose);
            eye[0] = now;
        });
        assertEquals(8 * rise + 1.65, eye[0], 1e-6);
    }

    @Test
    void theEyeStaysOutOfALowCeilingOnTheWayDown() {
        Course course = Course.onFloor();
        for (int i = 0; i < 6; i++) {
            course.box(-2, 0, -2 - 0.3 * i, 2, 0.3 * (6 - i), 10);
            course.box(-2, 0.3 * (6 - i) + 1.9, -2.9 - 0.3 * i, 2, 5, -2.6 - 0.3 * i);
        }
        var world = course.startAt(0, 1.8, 0).world();
        double[] highest = {0};
        course.hold(RUN, 2, player -> {
            Vector3d eye = player.feet().toVector().add(0, player.eyeMetres(), 0);
            for (int i = 0; i < world.size(); i++) {
                double gap = BruteForce.distance(eye, eye, world.collider(i).shape());
                assertTrue(gap > 0.09, () -> "eye at " + eye);
            }
            highest[0] = Math.max(highest[0], player.eyeMetres());
        });
        assertTrue(course.feet().z() < -5);
        assertTrue(highest[0] > 1.8, "the eye did not lag");
    }

    @Test
    void climbsStairsWhoseTreadsAreShorterThanTheFoot() {
        Course course = Course.onFloor();
        for (int i = 0; i < 8; i++) {
            course.box(-2, 0, -40, 2, 0.4 * (i + 1), -2 - 0.22 * i);
        }
        course.hold(FORWARD, 2, PlayerMotionTest::assertGrounded);
        assertEquals(8 * 0.4, course.feet().y(), 1e-6);
    }

    @Test
    void aStepHigherThanTheKneeStops() {
        Course course = stairs(0.41, 1).hold(FORWARD, 3);
        assertEquals(0, course.feet().y(), 1e-6);
        assertEquals(-2 + 0.301, course.feet().z(), 1e-4);
    }

    @Test
    void aStepTakenSlowlyIsClimbedToo() {
        Course course = stairs(0.4, 1).startAt(0, 0, -1.5).hold(PlayerInput.NONE.walking(2, 0), 20);
        assertEquals(0.4, course.feet().y(), 1e-6);
    }

    @Test
    void aSlopeOf49DegreesHolds() {
        Course course = Course.onFloor().slope(-8, -2, 49).hold(FORWARD, 1.5, PlayerMotionTest::assertGrounded);
        course.hold(PlayerInput.NONE, 1);
        Vec3 resting = course.feet();
        assertTrue(resting.y() > 1);
        course.hold(PlayerInput.NONE, 10, PlayerMotionTest::assertGrounded);
        assertEquals(resting, course.feet());
        course.hold(PlayerInput.NONE.walking(-100, 0).holding(Action.RUN), 2, PlayerMotionTest::assertGrounded);
        assertEquals(0, course.feet().y(), 1e-6);
    }

    /** The speed along a slope is the walking speed, up and, half a second after the turn, down. */
    @Test
    void slopesAreWalkedAtWalkingSpeed() {
        for (double degrees : new double[] {15, 30, 45}) {
            Course course = Course.onFloor().slope(-8, -2, degrees).hold(FORWARD, 1);
            for (int percent : new int[] {100, -100}) {
                PlayerInput input = PlayerInput.NONE.walking(percent, 0);
                Vec3 from = course.hold(input, 0.5).feet();
                Vec3 to = course.hold(input, 0.25).feet();
                double walked = to.toVector().distance(from.toVector());
                assertEquals(0.25 * 4, walked, 5e-3, degrees + " degrees at " + percent + " %");
            }
        }
    }

    @Test
    void aSlopeOf51DegreesIsNoWayUp() {
        Course course = Course.onFloor().slope(-8, -2, 51).hold(RUN, 3);
        assertTrue(course.feet().y() < 1e-3, () -> "climbed to " + course.feet());
    }

    @Test
    void aSlopeOf51DegreesSlides() {
        Course course = Course.onFloor().slope(-8, -2, 51).startAt(0, 6, -6);
        course.hold(PlayerInput.NONE, 3);
        assertEquals(0, course.feet().y(), 1e-6);
        assertTrue(course.feet().z() > -2.4);
    }

    @Test
    void aJumpReachesACrateOf90Centimetres() {
        Course course = Course.onFloor().box(-1, 0, -4, 1, 0.9, -2).startAt(0, 0, -1.6);
        course.hold(FORWARD, 0.5).hold(JUMP, 0.6).hold(FORWARD, 0.2);
        assertEquals(0.9, course.feet().y(), 1e-6);
    }

    @Test
    void aJumpDoesNotReachACrateOf120Centimetres() {
        Course course = Course.onFloor().box(-1, 0, -4, 1, 1.2, -2).startAt(0, 0, -1.6);
        for (int i = 0; i < 10; i++) {
            course.hold(JUMP, 0.6).hold(FORWARD, 0.6);
        }
        assertEquals(0, course.feet().y(), 1e-6);
    }

    @Test
    void jumpHasToBeLetGoOfBetweenJumps() {
        Course course = Course.onFloor().hold(JUMP, 2, player -> {});
        course.hold(JUMP, 1, PlayerMotionTest::assertGrounded);
        course.hold(FORWARD, 0.1).hold(JUMP, 0.1);
        assertFalse(course.state().player().isGrounded());
    }

    @Test
    void crouchesUnderAShaftAndStandsUpBehindIt() {
        Course course = Course.onFloor().box(-3, 1.2, -4, 3, 3, -2);
        assertEquals(-2 + 0.301, course.hold(FORWARD, 1).feet().z(), 1e-4);
        course.hold(CROUCHED, 1).hold(FORWARD, 0.2);
        assertEquals(PlayerDimensions.Stance.CROUCHED, course.state().player().stance(), "stood up inside the beam");
        course.hold(CROUCHED, 1.5).hold(FORWARD, 1);
        assertEquals(PlayerDimensions.Stance.STANDING, course.state().player().stance());
        assertTrue(course.feet().z() < -4.4);
    }

    @Test
    void aHeadAgainstTheCeilingEndsTheJump() {
        Course course = Course.onFloor().box(-3, 2.2, -3, 3, 3, 3);
        double[] highest = {0};
        course.hold(PlayerInput.NONE.holding(Action.JUMP), 1, player -> {
            highest[0] = Math.max(highest[0], player.feet().y());
        });
        assertEquals(2.2 - 1.8 - 0.002, highest[0], 1e-6);
        assertEquals(0, course.feet().y(), 1e-6);
    }

    @Test
    void walksThroughASlotHardlyWiderThanThePlayer() {
        Course wide = Course.onFloor().box(0.303, 0, -6, 3, 3, -2).box(-3, 0, -6, -0.303, 3, -2);
        assertTrue(wide.hold(FORWARD, 3).feet().z() < -7);
        Course narrow = Course.onFloor().box(0.299, 0, -6, 3, 3, -2).box(-3, 0, -6, -0.299, 3, -2);
        assertTrue(narrow.hold(FORWARD, 3).feet().z() > -2);
    }

    @Test
    void slidesAlongAWallAndStaysInACorner() {
        Course course = Course.onFloor().box(-3, 0, -5, 6, 3, -2).box(4, 0, -2, 6, 3, 5);
        course.hold(FORWARD.walking(100, 100), 0.8);
        double[] last = {course.feet().x()};
        course.hold(FORWARD.walking(100, 100), 0.3, player -> {
            assertTrue(player.feet().x() > last[0] + 0.02, () -> "does not slide at " + player.feet());
            assertEquals(0, player.feet().y(), 1e-6);
            last[0] = player.feet().x();
        });
        course.hold(FORWARD.walking(100, 100), 1);
        Vec3 corner = course.feet();
        course.hold(FORWARD.walking(100, 100), 2, player -> {
            assertEquals(corner.x(), player.feet().x(), 1e-6);
            assertEquals(corner.z(), player.feet().z(), 1e-6);
        });
        assertEquals(4 - 0.301, corner.x(), 1e-6);
        assertEquals(-2 + 0.301, corner.z(), 1e-6);
    }

    @Test
    void anAcuteCornerHoldsThePlayerStill() {
        Course course = Course.onFloor().slope(-8, -2, 80).box(-3, 0, -8, -0.5, 3, 3);
        course.hold(RUN.walking(100, -100), 2);
        Vec3 corner = course.feet();
        course.hold(RUN.walking(100, -100), 2);
        assertEquals(corner.x(), course.feet().x(), 1e-6);
        assertEquals(corner.z(), course.feet().z(), 1e-6);
    }

    @Test
    void betweenTwoSteepSlopesThereIsAFooting() {
        Course course = new Course().slope(-8, -2, 60).startAt(0, 3, -2);
        course.solid(new nephele.engine.level.Solid.Wedge(
                "facing",
                null,
                false,
                null,
                new Vec3(0, 5.196, 1),
                new Vec3(8, 10.392, 6),
                nephele.engine.level.BoxFace.PLUS_Z,
                java.util.Map.of()));
        course.hold(PlayerInput.NONE, 3);
        assertNotNull(course.state().player().ground());
    }

    @Test
    void tilesMakeNoBumps() {
        Course course = new Course();
        for (int i = -20; i < 5; i++) {
            course.box(-2, -1, i, 2, 0, i + 1);
        }
        course.hold(RUN, 2, player -> assertEquals(0, player.feet().y(), 1e-6));
        assertEquals(-12 + 6.0 / 12, course.feet().z(), 1e-3);
    }
}
