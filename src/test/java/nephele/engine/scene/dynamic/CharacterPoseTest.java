package nephele.engine.scene.dynamic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import nephele.engine.math.Vec3;
import nephele.engine.scene.FrameState.Posture;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** The character's feet follow the ground, its parts stay connected, and every posture is valid. */
class CharacterPoseTest {
    private static final Vec3 UP = new Vec3(0, 1, 0);
    private static final double BALL_METRES = 0.11;
    private static final double SOLE_METRES = 0.09;

    private static Posture walking(double ahead, double step, double stride, double travel) {
        return new Posture(new Vec3(0, 0.9, -ahead), UP, 0, 0, 1.8, step, stride, travel, 0, 0);
    }

    private static Vector3d ball(CharacterPose pose, CharacterPart foot) {
        Vector3d ball = pose.orientation(foot).transform(new Vector3d(0, -SOLE_METRES, -BALL_METRES));
        return ball.add(pose.centre(foot));
    }

    /** A foot on the ground moves less than 2 cm while the body passes over it, at every speed. */
    @Test
    void feetDoNotSlide() {
        for (double stride : new double[] {0.25, 0.5, 1, 1.5}) {
            CharacterPose pose = new CharacterPose();
            double metres = Gait.cycleMetres(stride);
            for (CharacterPart foot : new CharacterPart[] {CharacterPart.LEFT_FOOT, CharacterPart.RIGHT_FOOT}) {
                double touch = foot == CharacterPart.LEFT_FOOT ? 0 : 0.5;
                Vector3d first = null;
                for (double share = 0.25; share <= 0.95; share += 0.05) {
                    double step = (touch + share * Gait.contactFraction(stride)) % 1;
                    double ahead = share * Gait.contactFraction(stride) * metres;
                    pose.compute(walking(ahead, step, stride, 0), 0);
                    Vector3d ball = ball(pose, foot);
                    first = first == null ? ball : first;
                    assertEquals(0, ball.distance(first), 0.02, foot + " at stride " + stride + ", " + share);
                }
            }
        }
    }

    /** During slow walking the ball of the lower foot is within 3 cm of the ground. */
    @Test
    void feetKeepToTheGround() {
        CharacterPose pose = new CharacterPose();
        for (double step = 0; step < 1; step += 0.01) {
            pose.compute(walking(0, step, 0.3, 0), 0);
            double left = ball(pose, CharacterPart.LEFT_FOOT).y;
            double right = ball(pose, CharacterPart.RIGHT_FOOT).y;
            assertTrue(Math.min(left, right) < 0.03 && Math.min(left, right) > -0.03, step + ": " + left + " " + right);
        }
    }

    /** Thigh and shin, and shin and foot, share their joints in every posture; the head is at the eye. */
    @Test
    void theCharacterHoldsTogether() {
        Random random = new Random(3);
        CharacterPose pose = new CharacterPose();
        for (int i = 0; i < 2000; i++) {
            Posture p = new Posture(
                    new Vec3(7, 0.9, -3),
                    UP,
                    random.nextDouble() * 6,
                    random.nextDouble() * 3 - 1.5,
                    1.1 + 0.7 * random.nextDouble(),
                    random.nextDouble(),
                    1.6 * random.nextDouble(),
                    random.nextDouble() * 6 - 3,
                    random.nextDouble(),
                    random.nextDouble());
            pose.compute(p, i);
            assertJoined(pose, CharacterPart.LEFT_THIGH, 0.215, CharacterPart.LEFT_SHIN, 0.205);
            assertJoined(pose, CharacterPart.RIGHT_THIGH, 0.215, CharacterPart.RIGHT_SHIN, 0.205);
            assertJoined(pose, CharacterPart.LEFT_SHIN, 0.205, CharacterPart.LEFT_FOOT, 0);
            assertJoined(pose, CharacterPart.LEFT_UPPER_ARM, 0.145, CharacterPart.LEFT_FOREARM, 0.13);
            Vector3d eye = new Vector3d(7, 0.9 + p.heightMetres() / 2 - 0.15, -3);
            assertEquals(0, pose.centre(CharacterPart.HEAD).distance(eye), 0.02);
        }
    }

    private static void assertJoined(
            CharacterPose pose, CharacterPart upper, double below, CharacterPart lower, double above) {
        Vector3d end =
                pose.orientation(upper).transform(new Vector3d(0, -below, 0)).add(pose.centre(upper));
        Vector3d start =
                pose.orientation(lower).transform(new Vector3d(0, above, 0)).add(pose.centre(lower));
        assertEquals(0, end.distance(start), 0.01, upper + " and " + lower);
    }

    /** No value in a posture makes a part's position infinite or distant from the body. */
    @Test
    void everyPostureIsFinite() {
        double[] odd = {0, 1, -1, 1e9, -1e300, Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, 1e-320};
        Random random = new Random(5);
        CharacterPose pose = new CharacterPose();
        for (int i = 0; i < 5000; i++) {
            double[] v =
                    random.doubles(11, 0, odd.length).map(x -> odd[(int) x]).toArray();
            Vec3 up = new Vec3(v[0], v[1], v[2]);
            pose.compute(new Posture(Vec3.ZERO, up, v[3], v[4], v[5], v[6], v[7], v[8], v[9], v[10]), 0);
            for (CharacterPart part : CharacterPart.ALL) {
                assertTrue(pose.centre(part).length() < 4, part + " " + i);
                assertEquals(1, pose.orientation(part).lengthSquared(), 1e-9, part + " " + i);
            }
        }
    }
}
