package nephele.engine.portal.placement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Brush;
import nephele.engine.level.PortalShape;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Basis;
import nephele.engine.math.TriangleSoup;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.Portal;
import nephele.engine.portal.placement.PlacementResult.Refusal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Placement in whole rooms, on ramps and meshes, and far from the origin. */
class PlacementSurfacesTest {
    private static final Gun GUN = Walls.ARCH;

    private static Portal placed(PlacementSurfaces surfaces, Vec3 eye, double yawDegrees, double pitchDegrees) {
        return Walls.fits(answer(surfaces, eye, yawDegrees, pitchDegrees));
    }

    private static PlacementResult answer(
            PlacementSurfaces surfaces, Vec3 eye, double yawDegrees, double pitchDegrees) {
        ShotRay aim = new ShotRay(eye, Basis.ofYawPitch(Math.toRadians(yawDegrees), Math.toRadians(pitchDegrees)));
        return new Placement(surfaces, GUN).place("p", aim, List.of(), Obstacles.NONE);
    }

    /** Returns a room of 10 × 3 × 8 m with its floor at y = 0. */
    private static Walls room() {
        return new Walls()
                .box(-5, -1, -4, 5, 0, 4, true)
                .box(-5, 3, -4, 5, 4, 4, true)
                .box(-6, -1, -4, -5, 4, 4, true)
                .box(5, -1, -4, 6, 4, 4, true)
                .box(-6, -1, -5, 6, 4, -4, true)
                .box(-6, -1, 4, 6, 4, 5, true);
    }

    @Test
    void inARoomThePortalStandsOnTheFloorAndInTheCorner() {
        PlacementSurfaces room = room().surfaces();
        Vec3 eye = new Vec3(0, 1.65, 0);
        Portal ahead = placed(room, eye, 0, -13);
        assertEquals(1.05, ahead.centre().y(), 1e-6);
        assertEquals(-4, ahead.centre().z(), 1e-9);
        Portal corner = placed(room, eye, 49, 0);
        assertEquals(-4.4, corner.centre().x(), 1e-6);
        Portal ceiling = placed(room, eye, 30, 90);
        assertEquals(new Vec3(0, -1, 0), ceiling.normal());
        assertEquals(3, ceiling.centre().y(), 1e-9);
    }

    /** For a view straight down the result is finite, and the portal turns with the shooter. */
    @Test
    void straightDownThePortalLiesBeforeTheShooter() {
        PlacementSurfaces room = room().surfaces();
        for (double yaw = -180; yaw < 180; yaw += 7) {
            for (double pitch : new double[] {-90, -89.99, -89.9}) {
                Portal floor = placed(room, new Vec3(0, 1.65, 0), yaw, pitch);
                assertEquals(-Math.sin(Math.toRadians(yaw)), floor.frame().up().x(), 1e-9);
                assertEquals(-Math.cos(Math.toRadians(yaw)), floor.frame().up().z(), 1e-9);
                assertEquals(0, floor.centre().y(), 1e-9);
                assertEquals(0, floor.centre().x(), 3e-3);
            }
        }
    }

    /** At up to 1000 km from the origin the result is the same within 1e-6 m. */
    @Test
    void farFromTheOriginTheAnswerIsTheSame() {
        SplittableRandom random = new SplittableRandom(5);
        PlacementSurfaces near = corner(Vec3.ZERO);
        List<Vec3> shifts =
                List.of(new Vec3(1e4, -1e4, 1e4), new Vec3(12345.678, 0.1, -9876.54321), new Vec3(1e6, 1e6, -1e6));
        for (Vec3 shift : shifts) {
            PlacementSurfaces far = corner(shift);
            for (int i = 0; i < 300; i++) {
                double yaw = random.nextDouble(-40, 110);
                double pitch = random.nextDouble(-80, 40);
                PlacementResult a = answer(near, new Vec3(0, 1.65, 0), yaw, pitch);
                PlacementResult b = answer(far, new Vec3(shift.x(), 1.65 + shift.y(), shift.z()), yaw, pitch);
                assertEquals(a.getClass(), b.getClass());
                if (a instanceof PlacementResult.Fits fits) {
                    Vec3 p = fits.portal().centre();
                    Vec3 q = Walls.fits(b).centre();
                    assertEquals(p.x(), q.x() - shift.x(), 1e-6);
                    assertEquals(p.y(), q.y() - shift.y(), 1e-6);
                    assertEquals(p.z(), q.z() - shift.z(), 1e-6);
                } else {
                    assertEquals(Walls.refused(a), Walls.refused(b));
                }
            }
        }
    }

    private static PlacementSurfaces corner(Vec3 shift) {
        return new Walls()
                .shifted(shift)
                .box(-5, -1, -4, 5, 0, 4, true)
                .box(-6, -1, -5, 6, 4, -4, true)
                .box(-6, -1, -4, -5, 4, 4, true)
                .surfaces();
    }

    /** On a slope of 45° the portal lies in the slope, with its up along it, and stops at its edges. */
    @Test
    void aRampTakesPortalsUpAlongItsSlope() {
        Solid.Wedge wedge = new Solid.Wedge(
                "ramp",
                null,
                true,
                TextureMapping.WORLD,
                new Vec3(0, 1.5, 0),
                new Vec3(4, 3, 3),
                BoxFace.MINUS_Z,
                Map.of());
        PlacementSurfaces ramp = PlacementSurfaces.of(List.of(Brush.of(wedge)), List.of());
        Portal portal = placed(ramp, new Vec3(0, 2, 4), 0, -10);
        double half = Math.sqrt(0.5);
        assertEquals(half, portal.normal().y(), 1e-9);
        assertEquals(half, portal.frame().up().y(), 1e-9);
        assertEquals(-half, portal.frame().up().z(), 1e-9);
        Portal slid = placed(ramp, new Vec3(1.9, 2, 4), 0, -10);
        assertEquals(1.4, slid.centre().x(), 1e-6);
    }

    /** A portal on a ramp holds from wherever it was shot; the same one turned out of the ramp's plane does not. */
    @ParameterizedTest
    @ValueSource(doubles = {0.001, 10, 15, 20, 25, 30, 45})
    void aPortalOnARampHoldsFromWhereverItWasShot(double degrees) {
        double rise = 6 * Math.tan(Math.toRadians(degrees));
        Solid.Wedge wedge = new Solid.Wedge(
                "ramp",
                null,
                true,
                TextureMapping.WORLD,
                new Vec3(0, 0, 0),
                new Vec3(6, rise, 6),
                BoxFace.MINUS_Z,
                Map.of());
        PlacementSurfaces ramp = PlacementSurfaces.of(List.of(Brush.of(wedge)), List.of());
        for (int yaw = 0; yaw < 360; yaw += 45) {
            Portal portal = placed(ramp, new Vec3(0, 5, 0), yaw, -85);
            assertTrue(new Placement(ramp, GUN).holds(portal, List.of()), portal.toString());
            Vec3 normal = portal.normal().addScaled(0.05, portal.frame().right());
            Basis turned = Portal.facing(normal, portal.frame().up());
            assertFalse(
                    new Placement(ramp, GUN)
                            .holds(new Portal("p", portal.centre(), turned, portal.aperture()), List.of()),
                    portal.toString());
        }
    }

    /** Faces that differ by half a millimetre are one surface; faces that differ by two are not. */
    @Test
    void facesWithinAMillimetreAreOneSurface() {
        Walls flush = new Walls().box(-5, 0, -1, 0, 4, 0, true).box(0, 0, -1, 5, 4, 0.0005, true);
        assertEquals(0, Walls.fits(flush.shoot(GUN, 0, 2)).centre().x(), 1e-3);
        Walls proud = new Walls().box(-5, 0, -1, 0, 4, 0, true).box(0, 0, -1, 5, 4, 0.002, true);
        assertEquals(-0.6, Walls.fits(proud.shoot(GUN, -0.01, 2)).centre().x(), 1e-6);
        assertEquals(0.6, Walls.fits(proud.shoot(GUN, 0.01, 2)).centre().x(), 1e-6);
    }

    @Test
    void theTrianglesOfAMeshAreSurfacesFromTheirFront() {
        double[] positions = {-3, 0, 0, 3, 0, 0, 3, 4, 0, -3, 4, 0};
        List<SurfacePolygon> quad =
                new ArrayList<>(SurfacePolygon.of(new TriangleSoup(positions, new int[] {0, 1, 2, 0, 2, 3}), true));
        PlacementSurfaces mesh = PlacementSurfaces.of(List.of(), quad);
        assertEquals(1, mesh.regions());
        assertEquals(2.4, placed(mesh, new Vec3(2.9, 2, 5), 0, 0).centre().x(), 1e-6);
        assertEquals(Refusal.NOT_PORTALABLE, Walls.refused(answer(mesh, new Vec3(0, 2, -5), 180, 0)));
    }

    @Test
    void largeAndTinyAperturesFindTheirPlaces() {
        Walls wall = new Walls().wall(-500, -500, 500, 500);
        Gun huge = Walls.gun(PortalShape.ELLIPSE, 900, 999);
        assertEquals(0.5, Walls.fits(wall.shoot(huge, 3, 40)).centre().y(), 1e-6);
        Gun tiny = Walls.gun(PortalShape.ARCH, 0.01, 0.01);
        assertEquals(499.995, Walls.fits(wall.shoot(tiny, 499.997, 0)).centre().x(), 1e-6);
    }

    /** The result does not depend on earlier queries. */
    @Test
    void theSameQuestionHasTheSameAnswer() {
        PlacementSurfaces room = room().surfaces();
        Placement used = new Placement(room, GUN);
        SplittableRandom random = new SplittableRandom(6);
        for (int i = 0; i < 500; i++) {
            Basis view = Basis.ofYawPitch(random.nextDouble(-3, 3), random.nextDouble(-1.5, 1.5));
            ShotRay aim = new ShotRay(new Vec3(random.nextDouble(-4, 4), 1.65, random.nextDouble(-3, 3)), view);
            PlacementResult fresh = new Placement(room, GUN).place("p", aim, List.of(), Obstacles.NONE);
            assertEquals(fresh, used.place("p", aim, List.of(), Obstacles.NONE));
        }
    }
}
