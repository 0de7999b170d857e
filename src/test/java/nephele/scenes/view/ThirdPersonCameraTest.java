package nephele.scenes.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.math.Basis;
import nephele.engine.math.SeededNoise;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** The places and orientations of camera and entity. */
class ThirdPersonCameraTest {
    private static final Vec3 UP = new Vec3(0, 1, 0);
    private static final ViewerAngles ALONG_Z = ViewerAngles.between(Vec3.ZERO, new Vec3(0, 0, 1), UP);

    private static void assertNear(Vec3 expected, Vec3 actual) {
        assertTrue(expected.toVector().distance(actual.toVector()) < 1e-12, "expected " + expected + ", was " + actual);
    }

    @Test
    void theEntityRestsThreeUnitsAheadWithItsNoseAhead() {
        var start = ThirdPersonCamera.towing(Vec3.ZERO, ALONG_Z);
        assertNear(new Vec3(0, 0, 3), start.entity());
        var world = start.worldFromEntity();
        assertNear(new Vec3(0, 0, 4), Vec3.of(world.transformPosition(new Vector3d(0, 0, 1))));
        assertNear(new Vec3(0, 1, 3), Vec3.of(world.transformPosition(new Vector3d(0, 1, 0))));
        assertEquals(1, world.determinant(), 1e-12, "a rotation, no mirror");
    }

    @Test
    void whoSteersRightGoesToTheRightOfThePictureAndLeansThere() {
        var right = ThirdPersonCamera.towing(Vec3.ZERO, ALONG_Z).after(2, new Steering(1, 0, 6));
        assertNear(new Vec3(-12, 0, 3), right.entity());
        assertNear(new Vec3(-11, 0, 0), right.eye());
        assertEquals(ThirdPersonCamera.MOST_BANK_DEGREES, right.bankDegrees(), 1e-12);
        var leftWing = right.worldFromEntity().transformDirection(new Vector3d(1, 0, 0));
        assertTrue(leftWing.y > 0.5, "the left wing is up: " + leftWing.y);
        var left = ThirdPersonCamera.towing(Vec3.ZERO, ALONG_Z).after(2, new Steering(-1, 0, 6));
        assertEquals(-ThirdPersonCamera.MOST_BANK_DEGREES, left.bankDegrees(), 1e-12);
        assertEquals(0, left.after(1, Steering.NONE).bankDegrees(), 1e-15, "level again");
    }

    @Test
    void movingFollowsTheViewUpAndDown() {
        var up = ThirdPersonCamera.towing(Vec3.ZERO, ALONG_Z).turned(0, 90).after(1, new Steering(0, 1, 6));
        assertNear(new Vec3(0, 5, 0), up.eye());
    }

    @Test
    void turningSwingsTheEntityWithTheCamera() {
        var left = ThirdPersonCamera.towing(new Vec3(1, 2, 3), ALONG_Z).turned(90, 0);
        assertNear(new Vec3(1, 2, 3), left.eye());
        assertNear(new Vec3(4, 2, 3), left.entity());
    }

    @Test
    void aHeadingLooksWhereItWasTold() {
        var noise = new SeededNoise(59);
        for (int i = 0; i < 1000; i++) {
            Vec3 eye = point(noise, i, 0);
            Vec3 target = point(noise, i, 1);
            Vec3 up = point(noise, i, 2);
            Basis expected = Basis.lookAt(eye, target, up, Basis.WORLD);
            Basis actual = ViewerAngles.between(eye, target, up).basis();
            assertNear(expected.back(), actual.back());
            assertNear(expected.up(), actual.up());
            assertNear(expected.right(), actual.right());
        }
    }

    private static Vec3 point(SeededNoise noise, int i, int j) {
        return new Vec3(noise.unit(i, j, 0) - 0.5, noise.unit(i, j, 1) - 0.5, noise.unit(i, j, 2) - 0.5);
    }

    @Test
    void aHeadingIsGivenByEveryInput() {
        Vec3[] points = {Vec3.ZERO, new Vec3(1, 0, 0), UP, new Vec3(0, -1, 0), new Vec3(0, 0, 1)};
        for (Vec3 target : points) {
            for (Vec3 up : points) {
                var heading = ViewerAngles.between(Vec3.ZERO, target, up);
                var basis = heading.turned(5, -5)
                        .turned(Double.NaN, Double.POSITIVE_INFINITY)
                        .basis();
                assertEquals(1, basis.back().length(), 1e-12);
                assertEquals(0, basis.back().dot(basis.up()), 1e-12);
                if (!target.equals(Vec3.ZERO)) {
                    assertNear(target, Vec3.of(heading.basis().back().toVector().negate()));
                }
            }
        }
    }

    @Test
    void seventyTwoPressesAreATurnAndPitchEndsAtRightAngles() {
        var turned = ALONG_Z;
        for (int i = 0; i < 72; i++) {
            turned = turned.turned(5, 5);
        }
        assertEquals(0, turned.yawDegrees());
        assertEquals(90, turned.pitchDegrees());
        assertEquals(-90, turned.turned(0, -1e9).pitchDegrees());
        assertNear(new Vec3(0, -1, 0), turned.basis().back());
    }
}
