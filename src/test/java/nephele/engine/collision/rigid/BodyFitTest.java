package nephele.engine.collision.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.level.Body;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A body that flies straight at an aperture passes without contact exactly if its outline fits. */
class BodyFitTest {
    /** Distance of an outline from the aperture's edge within which either result is allowed: contacts look ahead. */
    private static final double MARGIN_METRES = 0.015;

    private static Vec3 v(double x, double y, double z) {
        return new Vec3(x, y, z);
    }

    @ParameterizedTest
    @CsvSource({"RECTANGLE, 1", "RECTANGLE, 2", "ARCH, 3", "ARCH, 4", "ELLIPSE, 5", "ELLIPSE, 6"})
    void passesUntouchedJustWhenItsOutlineFits(PortalShape shape, long seed) {
        Aperture aperture = Aperture.of(shape, 1.2, 2.1);
        SplittableRandom random = new SplittableRandom(seed);
        int fitting = 0;
        int held = 0;
        for (int i = 0; i < 25; i++) {
            Vec3 size = v(random.nextDouble(0.1, 1.2), random.nextDouble(0.1, 1.2), random.nextDouble(0.1, 1.2));
            Vec3 at = v(random.nextDouble(-0.25, 0.25), 1.05 + random.nextDouble(-0.4, 0.4), 1.5);
            Quaterniond turn =
                    new Quaterniond().rotateXYZ(random.nextDouble(6), random.nextDouble(6), random.nextDouble(6));
            double outside = outside(aperture, size, at, turn);
            if (Math.abs(outside) < MARGIN_METRES) {
                continue;
            }
            boolean untouched = fliesUntouched(aperture, size, at, turn);
            assertEquals(outside < 0, untouched, shape + ", box " + size + " at " + at + " is outside by " + outside);
            fitting += untouched ? 1 : 0;
            held += untouched ? 0 : 1;
        }
        assertTrue(fitting >= 3 && held >= 3, fitting + " fitted, " + held + " did not");
    }

    /** Returns the distance by which the outline of the corners exceeds the aperture: brute force, no GJK. */
    private static double outside(Aperture aperture, Vec3 size, Vec3 at, Quaterniond turn) {
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < 8; i++) {
            Vector3d corner = new Vector3d(
                    (i & 1) == 0 ? size.x() / 2 : -size.x() / 2,
                    (i & 2) == 0 ? size.y() / 2 : -size.y() / 2,
                    (i & 4) == 0 ? size.z() / 2 : -size.z() / 2);
            turn.transform(corner).add(at.x(), at.y() - 1.05, 0);
            most = Math.max(most, aperture.outside(corner.x, corner.y));
        }
        return most;
    }

    private static boolean fliesUntouched(Aperture aperture, Vec3 size, Vec3 at, Quaterniond turn) {
        BodyScene scene = new BodyScene()
                .weightless()
                .box(-10, -10, -1, 10, 10, 0)
                .box(30, -10, -10, 31, 10, 10)
                .pair(
                        BodyScene.portal(v(0, 1.05, 0), v(0, 0, 1), aperture),
                        BodyScene.portal(v(30, 1.05, 0), v(-1, 0, 0), aperture));
        int box = scene.add(new Body.Box("box", at, size, 1, null, 0, 0));
        scene.start().set(box, new BodyState(at, turn, v(0, 0, -2), Vec3.ZERO)).run(1.5, 120);
        return scene.centre(box).distance(30 - (3 - at.z()), at.y(), -at.x()) < 1e-9
                && scene.velocity(box).distance(-2, 0, 0) < 1e-12;
    }

    /** A plank that enters lengthways passes; across, the rim holds it. */
    @Test
    void plankGoesLengthwaysOnly() {
        Aperture aperture = Aperture.of(PortalShape.RECTANGLE, 1.2, 2.1);
        for (boolean lengthways : new boolean[] {true, false}) {
            Vec3 size = lengthways ? v(0.2, 0.2, 3) : v(3, 0.2, 0.2);
            assertEquals(lengthways, fliesUntouched(aperture, size, v(0, 1, 1.8), new Quaterniond()));
        }
    }

    /** The head corner of a rectangle is closed in an arch, and the foot corner in an ellipse. */
    @Test
    void cornersAreOpenInARectangleOnly() {
        Vec3 cube = v(0.2, 0.2, 0.2);
        for (PortalShape shape : PortalShape.values()) {
            Aperture aperture = Aperture.of(shape, 1.2, 2.1);
            boolean atHead = shape == PortalShape.RECTANGLE;
            boolean atFoot = shape != PortalShape.ELLIPSE;
            assertEquals(
                    atHead, fliesUntouched(aperture, cube, v(0.45, 1.95, 1.5), new Quaterniond()), shape + " head");
            assertEquals(
                    atFoot, fliesUntouched(aperture, cube, v(0.45, 0.15, 1.5), new Quaterniond()), shape + " foot");
        }
    }
}
