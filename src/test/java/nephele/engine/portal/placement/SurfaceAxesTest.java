package nephele.engine.portal.placement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Basis;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.Portal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Portals of shots at floors and ceilings turn to the right angles of their surface. */
final class SurfaceAxesTest {
    private static final ShotAids AIDS = new ShotAids(0, 1, StrictMath.toRadians(15));

    /** Returns a slab of 10 m × 8 m around the origin, turned about the vertical, with these things on it. */
    private static PlacementSurfaces slab(double turnDegrees, Brush... on) {
        List<Brush> solids = new ArrayList<>(List.of(on));
        double sin = StrictMath.sin(Math.toRadians(turnDegrees));
        double cos = StrictMath.cos(Math.toRadians(turnDegrees));
        solids.add(Brush.of(new Solid.Planes(
                "s",
                null,
                true,
                TextureMapping.WORLD,
                List.of(
                        face(cos, 0, -sin, 5),
                        face(-cos, 0, sin, 5),
                        face(sin, 0, cos, 4),
                        face(-sin, 0, -cos, 4),
                        face(0, 1, 0, 0.5),
                        face(0, -1, 0, 0.5)))));
        return PlacementSurfaces.of(solids, List.of());
    }

    private static Solid.PlaneFace face(double x, double y, double z, double distance) {
        return new Solid.PlaneFace(new Vec3(x, y, z), distance, null, null, null);
    }

    /** Returns the angle by which a portal differs from the direction of −z, to the left. */
    private static double yawDegrees(
            PlacementSurfaces surfaces, ShotAids aids, double yawDegrees, double pitchDegrees) {
        Basis view = Basis.ofYawPitch(Math.toRadians(yawDegrees), Math.toRadians(pitchDegrees));
        Vec3 eye = new Vec3(0, Math.copySign(0.5, -pitchDegrees), 0).addScaled(3, view.back());
        PlacementResult placed = new Placement(surfaces, Walls.ARCH)
                .with(aids)
                .place("p", new ShotRay(eye, view), List.of(), Obstacles.NONE);
        Portal portal = assertInstanceOf(PlacementResult.Fits.class, placed, placed.toString())
                .portal();
        Vec3 up = portal.frame().up();
        return Math.toDegrees(StrictMath.atan2(-up.x(), -up.z()));
    }

    @ParameterizedTest
    @CsvSource({
        // turn of the slab, yaw of the view, yaw of the portal
        "0, 14, 0",
        "0, -14.9, 0",
        "0, 16, 16",
        "0, 45, 45",
        "0, 76, 90",
        "0, -100, -90",
        "0, 170, 180",
        "30, 40, 30",
        "30, 44.9, 30",
        "30, 46, 46",
        "30, -52, -60",
        "30, 0, 0",
        "30, 130, 120"
    })
    void theNearestRightAngleWithin15Degrees(double turn, double yaw, double expected) {
        for (double pitch : new double[] {-60, 60}) {
            double found = yawDegrees(slab(turn), AIDS, yaw, pitch);
            assertEquals(0, Math.IEEEremainder(found - expected, 360), 1e-6, "pitch " + pitch);
            double plain = yawDegrees(slab(turn), ShotAids.NONE, yaw, pitch);
            assertEquals(0, Math.IEEEremainder(plain - yaw, 360), 1e-6);
        }
    }

    /** What stands on a floor has edges, too, unless they are shorter than the portal is wide. */
    @Test
    void whatStandsOnItCounts() {
        for (double length : new double[] {1, 3}) {
            List<Solid.PlaneFace> turned = new ArrayList<>();
            for (int i = 0; i < 4; i++) {
                double angle = Math.toRadians(30 + 90 * i);
                Vec3 normal = Directions.unit(new Vec3(StrictMath.cos(angle), 0, -StrictMath.sin(angle)));
                double middle = new Vec3(-3, 0, 2).dot(normal);
                turned.add(new Solid.PlaneFace(normal, middle + length / 2, null, null, null));
            }
            turned.add(face(0, 1, 0, 2));
            turned.add(face(0, -1, 0, -0.5));
            Brush block = Brush.of(new Solid.Planes("b", null, false, TextureMapping.WORLD, turned));
            assertEquals(length > 1.2 ? 30 : 25, yawDegrees(slab(0, block), AIDS, 25, -60), 1e-6);
        }
    }

    /** Where only the portal as the shooter faces has room, it does not turn; walls are as without the aid. */
    @Test
    void withoutRoomItDoesNotTurn() {
        // A strip as wide as the portal, 9 degrees off, between blocks too small to give a direction.
        double yaw = 9;
        List<Brush> strip = new ArrayList<>();
        Vec3 across = new Vec3(StrictMath.cos(Math.toRadians(yaw)), 0, -StrictMath.sin(Math.toRadians(yaw)));
        Vec3 along = new Vec3(-across.z(), 0, across.x());
        for (int side = -1; side <= 1; side += 2) {
            for (int piece = -3; piece <= 3; piece++) {
                double middle = piece;
                strip.add(Brush.of(new Solid.Planes(
                        "b" + side + piece,
                        null,
                        false,
                        TextureMapping.WORLD,
                        List.of(
                                new Solid.PlaneFace(scaled(across, -side), -0.605, null, null, null),
                                new Solid.PlaneFace(scaled(across, side), 1.7, null, null, null),
                                new Solid.PlaneFace(along, middle + 0.5, null, null, null),
                                new Solid.PlaneFace(scaled(along, -1), -middle + 0.5, null, null, null),
                                face(0, 1, 0, 2),
                                face(0, -1, 0, -0.5)))));
            }
        }
        assertEquals(yaw, yawDegrees(slab(0, strip.toArray(Brush[]::new)), AIDS, yaw, -60), 1e-6);
        assertEquals(0, yawDegrees(slab(0), AIDS, yaw, -60), 1e-6);
        Walls wall = new Walls().with(AIDS).wall(-4, -2, 4, 4);
        assertEquals(wall.shoot(Walls.ARCH, 0, 1), wall.with(ShotAids.NONE).shoot(Walls.ARCH, 0, 1));
    }

    private static Vec3 scaled(Vec3 v, double by) {
        return new Vec3(by * v.x(), by * v.y(), by * v.z());
    }

    @Test
    void aBoxOfAnotherSizeHasTheSameAxes() {
        Brush box = Brush.of(
                new Solid.Box("f", null, true, TextureMapping.WORLD, new Vec3(0, 0, 0), new Vec3(40, 1, 3), Map.of()));
        assertEquals(0, yawDegrees(PlacementSurfaces.of(List.of(box), List.of()), AIDS, 12, -60), 1e-6);
    }
}
