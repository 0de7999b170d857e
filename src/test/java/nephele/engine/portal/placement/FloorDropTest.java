package nephele.engine.portal.placement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.level.Terrain;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Basis;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.Portal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Portals of shots at walls slide down to the floor before them. */
final class FloorDropTest {
    private static final ShotAids AIDS = new ShotAids(0.8, StrictMath.cos(Math.toRadians(50)), 0);
    private static final double TALL = 2.1;

    /** Returns a wall of 8 m × 4 m. */
    private static Walls wall() {
        return new Walls().with(AIDS).wall(-4, -2, 4, 4);
    }

    private static Walls withFloor(Walls walls, double height) {
        return walls.box(-4, height - 1, 0, 4, height, 6, false);
    }

    private static double sill(Portal portal) {
        return portal.centre().y() - TALL / 2;
    }

    /** Returns the height of the lower edge of a shot's portal. */
    private static double sill(Walls walls, double x, double y, Portal... others) {
        return sill(Walls.fits(walls.shoot(Walls.ARCH, x, y, others)));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-6, 0.02, 0.3, 0.6, 0.799})
    void aLowerEdgeNearAboveTheFloorGoesDownToIt(double above) {
        assertEquals(0, sill(withFloor(wall(), 0), 1, TALL / 2 + above), 1e-6);
    }

    @Test
    void higherOnesAndThoseWithoutFloorStay() {
        assertEquals(0.82, sill(withFloor(wall(), 0), 0, TALL / 2 + 0.82), 1e-9);
        assertEquals(0.6, sill(wall(), 0, TALL / 2 + 0.6), 1e-9);
        // The floor ends before the portal.
        assertEquals(0.6, sill(wall().box(1, -1, 0, 4, 0, 6, false), 0, TALL / 2 + 0.6), 1e-9);
    }

    @Test
    void withoutTheAidOrWithAGunThatForbidsItNothingSlides() {
        Walls walls = withFloor(wall(), 0);
        Gun free = Walls.ARCH;
        Gun forbids = new Gun(free.aperture(), free.rangeMetres(), free.slideMetres(), false);
        assertEquals(0.5, sill(Walls.fits(walls.shoot(forbids, 0, TALL / 2 + 0.5))), 1e-9);
        assertEquals(0.5, sill(walls.with(ShotAids.NONE), 0, TALL / 2 + 0.5), 1e-9);
    }

    /** Where a room is so low that the portal slides down from the ceiling, the floor is next. */
    @Test
    void theFloorComesBeforeTheCeiling() {
        for (double aim : new double[] {1, 1.4, 1.9}) {
            Walls low = withFloor(wall(), 0).box(-4, 2.4, 0, 4, 3, 6, false);
            assertEquals(0, sill(low, 0, aim), 1e-6, "aimed at " + aim);
        }
    }

    /** The slope of a floor of the player's limit counts, a steeper one does not; a mesh and a floor aside are floors. */
    @Test
    void whatOneCanStandOnIsAFloor() {
        assertEquals(0, sill(wall().box(-4, -1, 0.2, 4, 0, 6, false), 0, 1.5), 5e-3, "20 cm before the wall");
        assertEquals(0, sill(wall().box(-4, -1, 0, 4, 0, 0.1, false), 0, 1.5), 5e-3, "a ledge of 10 cm");
        assertEquals(0.45, sill(wall().box(-4, -1, 0, 4, 0, 0.06, false), 0, 1.5), 1e-9, "a frame of 6 cm");
        Walls mesh = wall().sheet(new Vec3(-4, 0, 0), new Vec3(-4, 0, 4), new Vec3(4, 0, 0))
                .sheet(new Vec3(4, 0, 0), new Vec3(4, 0, 4), new Vec3(-4, 0, 4));
        assertEquals(0, sill(mesh, 1, 1.5), 5e-3);
        for (double slope : new double[] {20, 49, 51, 70}) {
            // A ramp that falls away from the wall.
            double fall = StrictMath.tan(Math.toRadians(slope)) * 4;
            Walls ramp =
                    wall().sheet(new Vec3(-4, 0, 0), new Vec3(-4, -fall, 4), new Vec3(4, -fall, 4), new Vec3(4, 0, 0));
            boolean isFloor = slope < 50;
            assertEquals(isFloor ? 0 : 0.3, sill(ramp, 0, TALL / 2 + 0.3), 0.07, "slope of " + slope);
        }
    }

    /** The lower edge lies on the highest of what is under it, so that no ground is in the opening. */
    @Test
    void theHighestGroundUnderTheEdgeCounts() {
        double[] heights = {0, 0.2, 0.1};
        HeightField field = HeightField.of(
                new Vec3(-8, 0, -8), 1, 17, 17, (column, row) -> heights[Math.max(0, Math.min(2, column - 7))]);
        Terrain said = new Terrain(
                "g", "none", Vec3.ZERO, new Terrain.Sides(1, 1), new Terrain.HeightRange(0, 1), List.of(), false);
        Brush wall = Brush.of(new Solid.Box(
                "w", null, true, TextureMapping.WORLD, new Vec3(0, 1, -0.5), new Vec3(8, 6, 1), Map.of()));
        PlacementSurfaces surfaces = PlacementSurfaces.of(new StaticShapes(
                List.of(wall), PlacedModels.NONE, List.of(new StaticShape.HeightGrid(0, said, field))));
        ShotRay aim = new ShotRay(new Vec3(0, 1.5, 5), Basis.WORLD);
        PlacementResult placed =
                new Placement(surfaces, Walls.ARCH).with(AIDS).place("p", aim, List.of(), Obstacles.NONE);
        assertEquals(0.19, sill(Walls.fits(placed)), 0.012);
    }

    /** A body is a floor where nothing fixed is one, if it is level. */
    @Test
    void bodiesAreFloors() {
        Obstacles raft = (from, path) -> {
            double fraction = (from.y() - 0.1) / -path.y();
            return path.y() < 0 && fraction <= 1 ? fraction : 1;
        };
        assertEquals(0.1, sill(wall().with(raft), 0, 1.6), 1e-6);
        assertEquals(0, sill(withFloor(wall().with(raft), 0), 0, 1.6), 1e-6);
        Obstacles steep = (from, path) -> {
            double fraction = (from.y() - 0.1 - 1.3 * from.x()) / -path.y();
            return path.y() < 0 && fraction <= 1 ? fraction : 1;
        };
        assertEquals(0.55, sill(wall().with(steep), 0, 1.6), 1e-6);
    }

    /** Beside another portal there is a place on the floor; without one the shot goes where it goes without the aid. */
    @Test
    void otherPortalsAndFacesWithoutPortalsAreRespected() {
        Walls walls = withFloor(wall(), 0);
        Portal other = Walls.fits(walls.shoot(Walls.ARCH, 0, 1.5));
        Portal beside = Walls.fits(walls.shoot(Walls.ARCH, 0.7, 1.8, other));
        assertEquals(0, sill(beside), 1e-6);
        assertEquals(1.2, beside.centre().x(), 1e-6);
        Walls panel = withFloor(new Walls().with(AIDS).without(-4, -2, 4, 0.3).wall(-4, 0.3, 4, 4), 0);
        assertEquals(0.6, sill(panel, 0, TALL / 2 + 0.6), 1e-9);
        Walls slot = withFloor(new Walls().with(AIDS).wall(-0.7, -2, 0.7, 6), 0);
        Portal low = Walls.fits(slot.shoot(Walls.ARCH, 0, 1.5));
        Walls same = withFloor(new Walls().wall(-0.7, -2, 0.7, 6), 0);
        assertEquals(same.shoot(Walls.ARCH, 0, 2.8, low), slot.shoot(Walls.ARCH, 0, 2.8, low));
    }

    /** A shot that grazes an edge, a frame or another portal finds the place that it finds without the aid, lowered. */
    @Test
    void grazingShotsFindTheNearestPlace() {
        Walls plain = withFloor(new Walls().wall(-4, -2, 4, 4), 0).box(1.5, 0, 0, 1.6, 3, 0.2, false);
        Walls aided = withFloor(wall(), 0).box(1.5, 0, 0, 1.6, 3, 0.2, false);
        Portal other = Walls.fits(plain.shoot(Walls.ARCH, -2, 0.9));
        for (double x = -3.95; x < 3.95; x += 0.1) {
            PlacementResult without = plain.shoot(Walls.ARCH, x, 1.3, other);
            PlacementResult with = aided.shoot(Walls.ARCH, x, 1.3, other);
            if (without instanceof PlacementResult.Fits fits) {
                Portal lowered = Walls.fits(with);
                assertEquals(fits.portal().centre().x(), lowered.centre().x(), 1e-6, "aimed at " + x);
                assertEquals(0, sill(lowered), 1e-6);
                assertTrue(fits.slideMetres() <= 0.75 + 1e-9);
            } else if (with instanceof PlacementResult.Fits fits) {
                assertEquals(x, fits.portal().centre().x(), 0.75 + 1e-9);
                assertEquals(0, sill(fits.portal()), 1e-6);
            } else {
                assertEquals(without, with);
            }
        }
    }

    /** A leaning wall's portal slides down along it. */
    @Test
    void wallsMayLean() {
        for (double lean : new double[] {-30, -10, 10, 30}) {
            double slope = StrictMath.tan(Math.toRadians(lean));
            Walls leaning = new Walls()
                    .with(AIDS)
                    .solid(new Solid.Planes(
                            "w",
                            null,
                            true,
                            TextureMapping.WORLD,
                            List.of(
                                    plane(new Vec3(0, slope, 1), 0),
                                    plane(new Vec3(0, 0, -1), 9),
                                    plane(new Vec3(1, 0, 0), 4),
                                    plane(new Vec3(-1, 0, 0), 4),
                                    plane(new Vec3(0, 1, 0), 5),
                                    plane(new Vec3(0, -1, 0), 0))))
                    .box(-4, -1, -9, 4, 0, 6, false);
            Portal portal = Walls.fits(leaning.shoot(Walls.ARCH, 0, 1.6));
            assertEquals(0, portal.world(0, -TALL / 2, 0).y(), 8e-3, "leaning by " + lean);
        }
    }

    private static Solid.PlaneFace plane(Vec3 normal, double distance) {
        return new Solid.PlaneFace(Directions.unit(normal), distance, null, null, null);
    }
}
