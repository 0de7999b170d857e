package nephele.engine.portal.placement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.level.PortalShape;
import nephele.engine.level.Terrain;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.Portal;
import nephele.engine.portal.placement.PlacementResult.Refusal;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Shots straight down at terrains. */
class GroundRegionTest {
    private static final Gun GUN = new Gun(Aperture.of(PortalShape.RECTANGLE, 1.2, 2.1), 100, 0.75);

    private static PlacementResult shot(double bumpMetres, boolean isPortalable, double x, double z) {
        HeightField field = HeightField.of(
                Vec3.ZERO, 0.7, 33, 33, (column, row) -> column < 16 ? 0.25 : bumpMetres * ((column + row) % 2));
        Terrain said = new Terrain(
                "g",
                "none",
                Vec3.ZERO,
                new Terrain.Sides(1, 1),
                new Terrain.HeightRange(0, 1),
                List.of(),
                isPortalable);
        StaticShapes statics =
                new StaticShapes(List.of(), PlacedModels.NONE, List.of(new StaticShape.HeightGrid(0, said, field)));
        Basis down = Basis.ofYawPitch(0, Math.toRadians(-89));
        ShotRay aim = new ShotRay(new Vec3(x, 5, z), down);
        return new Placement(PlacementSurfaces.of(statics), GUN).place("p", aim, List.of(), Obstacles.NONE);
    }

    @ParameterizedTest
    @CsvSource({"5, 10", "3.33, 7.77", "2, 18"})
    void flatGroundTakesPortals(double x, double z) {
        PlacementResult result = shot(1, true, x, z);
        assertTrue(result instanceof PlacementResult.Fits, result.toString());
        Portal portal = ((PlacementResult.Fits) result).portal();
        assertEquals(0.25, portal.centre().y(), 1e-9);
        assertEquals(1, portal.normal().y(), 1e-12);
    }

    /** Bumps of 5 cm, the step between the halves, and a terrain that takes none. */
    @ParameterizedTest
    @CsvSource({"0.05, true, 16, NOT_FLAT", "1, true, 10.9, NOT_FLAT", "0, false, 5, NOT_PORTALABLE"})
    void otherGroundSaysWhyNot(double bump, boolean isPortalable, double x, Refusal reason) {
        PlacementResult result = shot(bump, isPortalable, x, 10);
        assertTrue(result instanceof PlacementResult.Refused, result.toString());
        assertEquals(reason, ((PlacementResult.Refused) result).reason());
    }
}
