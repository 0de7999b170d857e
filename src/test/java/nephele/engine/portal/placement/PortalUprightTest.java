package nephele.engine.portal.placement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import nephele.engine.math.Basis;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** The up direction of a portal on walls, slopes and level surfaces. */
class PortalUprightTest {
    private static final Vec3 FLOOR = new Vec3(0, 1, 0);
    private static final Vec3 CEILING = new Vec3(0, -1, 0);

    private static Vec3 leaning(double fromUpright, double turn) {
        double level = Math.sin(fromUpright);
        return new Vec3(level * Math.sin(turn), Math.cos(fromUpright), level * Math.cos(turn));
    }

    private static void assertNear(Vec3 expected, Vec3 actual, double radians) {
        assertTrue(Directions.angle(expected, actual) <= radians, expected + " is not " + actual);
    }

    @Test
    void itIsOfUnitLengthAndInThePlaneForAnySurfaceAndView() {
        SplittableRandom random = new SplittableRandom(2);
        for (int i = 0; i < 10_000; i++) {
            Vec3 normal = leaning(random.nextDouble(0, Math.PI), random.nextDouble(-3.2, 3.2));
            Basis view = Basis.lookAt(
                    Vec3.ZERO,
                    leaning(random.nextDouble(0, Math.PI), random.nextDouble(-3.2, 3.2)),
                    leaning(random.nextDouble(0, Math.PI), random.nextDouble(-3.2, 3.2)),
                    Basis.WORLD);
            Vec3 up = PortalUpright.on(normal, view);
            assertEquals(1, up.length(), 1e-12);
            assertEquals(0, up.dot(normal), 1e-12);
        }
    }

    @Test
    void onWallsAndSlopesItIsUpAlongThemWhoeverLooks() {
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 1000; i++) {
            Vec3 normal = leaning(Math.toRadians(random.nextDouble(31, 149)), random.nextDouble(-3, 3));
            Vec3 up =
                    PortalUpright.on(normal, Basis.ofYawPitch(random.nextDouble(-3, 3), random.nextDouble(-1.5, 1.5)));
            Vec3 across = FLOOR.cross(normal);
            assertEquals(0, up.dot(across), 1e-12);
            assertTrue(up.y() > 0);
        }
    }

    @Test
    void onFloorsAndCeilingsItIsTheViewWithoutItsPartAlongTheNormal() {
        for (double yaw = -3; yaw < 3; yaw += 0.1) {
            for (double pitch = -1.5; pitch <= 1.5; pitch += 0.1) {
                Basis view = Basis.ofYawPitch(yaw, pitch);
                Vec3 ahead = Directions.unit(-view.back().x(), 0, -view.back().z());
                assertNear(ahead, PortalUpright.on(FLOOR, view), 1e-12);
                assertNear(ahead, PortalUpright.on(CEILING, view), 1e-12);
            }
        }
    }

    /** The view's component along the floor vanishes; the direction ahead does not. */
    @Test
    void straightDownItStaysWhatIsAheadAndTurnsWithTheShooter() {
        for (double yaw = -3; yaw < 3; yaw += 0.1) {
            Vec3 ahead = new Vec3(-Math.sin(yaw), 0, -Math.cos(yaw));
            for (double off : new double[] {0, 1e-300, 1e-16, 1e-9, 1e-4, 0.1}) {
                assertNear(ahead, PortalUpright.on(FLOOR, Basis.ofYawPitch(yaw, off - Math.PI / 2)), 1e-9);
                assertNear(ahead, PortalUpright.on(CEILING, Basis.ofYawPitch(yaw, Math.PI / 2 - off)), 1e-9);
            }
            Vec3 right = new Vec3(Math.cos(yaw), 0, -Math.sin(yaw));
            Vec3 behind = new Vec3(-ahead.x(), 0, -ahead.z());
            assertNear(ahead, PortalUpright.on(FLOOR, new Basis(right, ahead, FLOOR)), 1e-15);
            assertNear(ahead, PortalUpright.on(CEILING, new Basis(right, behind, CEILING)), 1e-15);
        }
    }

    /** The up direction is continuous while walls tilt to floor and to ceiling, for any view. */
    @Test
    void nothingJumpsWhileASurfaceTilts() {
        SplittableRandom random = new SplittableRandom(4);
        double most = 0;
        for (int i = 0; i < 300; i++) {
            double turn = random.nextDouble(-3, 3);
            // Views against the surface, exactly along it (where up the wall is opposite to ahead on the floor), or
            // random.
            double yaw = i % 3 == 0 ? turn : i % 3 == 1 ? turn + Math.PI : random.nextDouble(-3, 3);
            Basis view = Basis.ofYawPitch(yaw, random.nextDouble(-1.57, 1.57));
            Vec3 last = null;
            for (double degrees = 0; degrees <= 180; degrees += 0.05) {
                Vec3 up = PortalUpright.on(leaning(Math.toRadians(degrees), turn), view);
                most = last == null ? most : Math.max(most, Directions.angle(last, up));
                last = up;
            }
        }
        // Half a turn over 20° of tilt, twice as fast in the middle: 20 times as fast as the surface tilts.
        assertTrue(most <= Math.toRadians(0.05) * 20, Math.toDegrees(most) + " degrees at once");
    }

    @Test
    void nothingJumpsWhileTheShooterLooksUpAndDown() {
        for (double tilt : new double[] {0, 5, 15, 25, 60, 155, 170, 180}) {
            Vec3 normal = leaning(Math.toRadians(tilt), 0.7);
            Vec3 last = null;
            for (double pitch = -90; pitch <= 90; pitch += 0.1) {
                Vec3 up = PortalUpright.on(normal, Basis.ofYawPitch(0.3, Math.toRadians(pitch)));
                if (last != null) {
                    assertNear(last, up, 1e-6);
                }
                last = up;
            }
        }
    }
}
