package nephele.engine.portal.placement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.function.DoubleBinaryOperator;
import nephele.engine.level.Brush;
import nephele.engine.level.PortalShape;
import nephele.engine.level.Solid;
import nephele.engine.level.Terrain;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.Portal;
import nephele.engine.portal.placement.PlacementResult.Refusal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Shots at uneven terrains. */
@Execution(ExecutionMode.CONCURRENT)
class GroundPlacementTest {
    private static final double CELL = 0.25;
    private static final int SAMPLES = 65;
    private static final Gun GUN = new Gun(Aperture.of(PortalShape.ARCH, 1.2, 2.1), 200, 0.75);

    /** Ground of 16 m around a place, with what stands on it. */
    private record Ground(Vec3 middle, HeightField field, List<Brush> solids) {
        static Ground of(Vec3 middle, DoubleBinaryOperator heights, Brush... solids) {
            Vec3 corner = middle.plus(new Vec3(-8, 0, -8));
            HeightField field = HeightField.of(
                    corner,
                    CELL,
                    SAMPLES,
                    SAMPLES,
                    (column, row) -> heights.applyAsDouble(CELL * column - 8, CELL * row - 8));
            return new Ground(middle, field, List.of(solids));
        }

        private Placement placement() {
            Terrain said = new Terrain(
                    "g", "none", Vec3.ZERO, new Terrain.Sides(1, 1), new Terrain.HeightRange(0, 1), List.of(), true);
            return new Placement(
                    PlacementSurfaces.of(new StaticShapes(
                            solids, PlacedModels.NONE, List.of(new StaticShape.HeightGrid(0, said, field)))),
                    GUN);
        }

        /** Shoots from a height above the ground so that the shot hits a place seen from the middle. */
        PlacementResult shot(double x, double z, double pitchDegrees, double yawDegrees, Portal... others) {
            double y = HeightFieldSurface.y(field, middle.x() + x, middle.z() + z);
            Basis view = Basis.ofYawPitch(Math.toRadians(yawDegrees), Math.toRadians(pitchDegrees));
            Vec3 eye = new Vec3(middle.x() + x, y, middle.z() + z).addScaled(3, view.back());
            return placement().place("p", new ShotRay(eye, view), List.of(others), Obstacles.NONE);
        }
    }

    private static double bumps(double x, double z) {
        return 0.007 * Math.sin(5 * x) * Math.cos(4 * z);
    }

    private static Portal fits(PlacementResult result) {
        return assertInstanceOf(PlacementResult.Fits.class, result, result.toString())
                .portal();
    }

    private static Brush stone(double x, double z) {
        return Brush.of(new Solid.Box(
                "s", null, false, TextureMapping.WORLD, new Vec3(x, 0, z), new Vec3(0.5, 2, 0.5), Map.of()));
    }

    /** Straight down, at grazing angles from several sides, and on slopes up to 80 degrees. */
    @ParameterizedTest
    @CsvSource({
        "-90, 0, 0",
        "-45, 40, 0",
        "-8, 100, 0",
        "-3, 211, 0",
        "-90, 0, 10",
        "-40, 70, 20",
        "-20, 200, 30",
        "-60, 0, 45",
        "-89, 10, 60",
        "-89, 120, 80"
    })
    void unevenGroundTakesThePortalWhereItIsAimed(double pitch, double yaw, double slopeDegrees) {
        double slope = Math.tan(Math.toRadians(slopeDegrees));
        double cosine = Math.cos(Math.toRadians(slopeDegrees));
        Ground ground = Ground.of(Vec3.ZERO, (x, z) -> slope * x + bumps(x, z) / cosine);
        PlacementResult result = ground.shot(0.3, -0.2, pitch, yaw);
        Portal portal = fits(result);
        assertEquals(0, ((PlacementResult.Fits) result).slideMetres());
        assertEquals(cosine, portal.normal().y(), 0.02);
        assertEquals(0, portal.centre().x() - 0.3, 0.021);
        assertTrue(ground.placement().holds(portal, List.of()));
    }

    /**
     * Between floors and walls the upright turns with the shooter's view. A portal holds whoever made it, and no longer
     * when the ground tilts, even about the portal's own axes, or rises by a millimetre.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, 10, 15, 20, 25, 30, 45, 60})
    void aPortalOnASlopeHoldsAsLongAsTheGroundIsTheSame(double degrees) {
        double slope = Math.tan(Math.toRadians(degrees));
        double cosine = Math.cos(Math.toRadians(degrees));
        DoubleBinaryOperator heights = (x, z) -> slope * x + bumps(x, z) / cosine;
        Placement placement = Ground.of(Vec3.ZERO, heights).placement();
        Placement risen = Ground.of(Vec3.ZERO, (x, z) -> heights.applyAsDouble(x, z) + 1e-3 / cosine)
                .placement();
        for (int yaw = 0; yaw < 360; yaw += 45) {
            Portal portal = fits(Ground.of(Vec3.ZERO, heights).shot(0.3, -0.2, -89, yaw));
            assertTrue(placement.holds(portal, List.of()), portal.toString());
            assertFalse(risen.holds(portal, List.of()), portal.toString());
            assertFalse(placement.holds(turned(portal, 0.02, 0), List.of()), "about its up axis");
            assertFalse(placement.holds(turned(portal, 0, 0.02), List.of()), "about its right axis");
        }
    }

    /** Returns a portal with its normal turned about its own axes, in radians. */
    private static Portal turned(Portal portal, double aboutUp, double aboutRight) {
        Basis axes = portal.frame();
        Vec3 normal = axes.back().addScaled(aboutUp, axes.right()).addScaled(aboutRight, axes.up());
        return new Portal(portal.id(), portal.centre(), Portal.facing(normal, axes.up()), portal.aperture());
    }

    @ParameterizedTest
    @CsvSource({"0.0125, 13", "0.05, 50"})
    void whatIsRefusedSaysByHowMuch(double metres, long millimetres) {
        Ground ground = Ground.of(
                Vec3.ZERO, (x, z) -> metres * ((Math.round(x / CELL) + Math.round(z / CELL)) % 2 == 0 ? 1 : -1));
        var refused = assertInstanceOf(PlacementResult.Refused.class, ground.shot(0.3, -0.2, -60, 20));
        assertEquals(Refusal.NOT_FLAT, refused.reason());
        assertEquals(metres, refused.unevenMetres(), 1e-4);
        assertEquals(millimetres, PlacementResult.Refused.millimetres(refused.unevenMetres()));
    }

    /** A ridge through rough ground: the portal slides from beside it onto the even part. */
    @Test
    void aPortalSlidesToEvenGround() {
        Ground ground = Ground.of(
                Vec3.ZERO,
                (x, z) -> z < 0.4 ? bumps(x, z) : 0.06 * ((Math.round(x / CELL) + Math.round(z / CELL)) % 2));
        PlacementResult result = ground.shot(0, -0.4, -70, 0);
        Portal portal = fits(result);
        double slide = ((PlacementResult.Fits) result).slideMetres();
        assertTrue(slide > 0.1 && slide <= 0.75, result.toString());
        assertTrue(portal.centre().z() < -0.6, result.toString());
        assertTrue(ground.placement().holds(portal, List.of()));
    }

    /** Moving ground and shooter moves the portal. */
    @ParameterizedTest
    @ValueSource(doubles = {3.25, 1e4, -1e6})
    void aMovedTerrainMovesThePortal(double far) {
        Vec3 to = new Vec3(far, far / 4, -far / 2);
        for (int i = 0; i < 12; i++) {
            double x = 0.17 * i - 1;
            DoubleBinaryOperator heights = (px, pz) -> 0.2 * px + 1.7 * bumps(px, pz);
            PlacementResult here = Ground.of(Vec3.ZERO, heights).shot(x, 0.1 * i, -50, 31 * i);
            PlacementResult there = Ground.of(to, heights).shot(x, 0.1 * i, -50, 31 * i);
            assertEquals(here.getClass(), there.getClass());
            if (here instanceof PlacementResult.Fits fits) {
                Vec3 moved = fits(there).centre().minus(to);
                assertEquals(0, moved.minus(fits.portal().centre()).length(), 1e-6, here + " " + there);
            }
        }
    }

    /** Seen from all sides, along the border: the aperture stays over the terrain. */
    @ParameterizedTest
    @CsvSource({"7.9, 0", "-7.9, 1", "0.5, 7.95", "0, -7.8", "7.9, 7.9"})
    void theApertureStaysWithinTheBorder(double x, double z) {
        for (int yaw = 0; yaw < 360; yaw += 40) {
            PlacementResult result =
                    Ground.of(Vec3.ZERO, GroundPlacementTest::bumps).shot(x, z, -80, yaw);
            if (result instanceof PlacementResult.Fits) {
                for (Vec3 corner : fits(result).corners()) {
                    assertTrue(Math.max(Math.abs(corner.x()), Math.abs(corner.z())) <= 8 + 1e-6, corner.toString());
                }
            } else {
                assertEquals(Refusal.EDGE, ((PlacementResult.Refused) result).reason());
            }
        }
    }

    @Test
    void somethingOnTheGroundIsNotCovered() {
        for (int yaw = 0; yaw < 360; yaw += 45) {
            PlacementResult result = Ground.of(Vec3.ZERO, GroundPlacementTest::bumps, stone(0.7, 0))
                    .shot(0, 0, -85, yaw);
            Portal portal = fits(result);
            double away = portal.aperture().outside(portal.across(0.7, 0, 0), portal.upward(0.7, 0, 0));
            assertTrue(away >= 0.25 - 1e-3, result.toString());
        }
    }

    /** Two portals on differing planes of one hollow do not overlap, and stay apart by no more than needed. */
    @Test
    void twoPortalsNearEachOther() {
        Ground ground = Ground.of(Vec3.ZERO, (x, z) -> 0.004 * x * x + 0.004 * z * z + bumps(x, z) / 2);
        Portal first = fits(ground.shot(-0.2, 0, -80, 0));
        PlacementResult result = ground.shot(0.9, 0.1, -80, 0, first);
        Portal second = fits(result);
        assertTrue(((PlacementResult.Fits) result).slideMetres() > 0.05, result.toString());
        for (Vec3 corner : second.corners()) {
            double across = first.across(corner.x(), corner.y(), corner.z());
            double upward = first.upward(corner.x(), corner.y(), corner.z());
            assertTrue(first.aperture().outside(across, upward) >= -1e-3, corner.toString());
        }
        assertEquals(
                Refusal.OVERLAPS_OTHER, ((PlacementResult.Refused) ground.shot(-0.2, 0.05, -80, 0, first)).reason());
    }
}
