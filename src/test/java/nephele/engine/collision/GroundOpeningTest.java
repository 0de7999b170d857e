package nephele.engine.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import nephele.engine.level.Brush;
import nephele.engine.level.PortalShape;
import nephele.engine.level.Solid;
import nephele.engine.level.TestTerrain;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.portal.ground.GroundSeat;
import org.junit.jupiter.api.Test;

/** The world opened at a portal on uneven ground is the ground itself beside the aperture. */
class GroundOpeningTest {
    private static final Aperture APERTURE = Aperture.of(PortalShape.RECTANGLE, 1.2, 2.1);
    private static final Vec3 NORTH = new Vec3(0, 0, -1);

    /** Bumps of ±9 mm; from 0.8 m beside the portal on, the ground falls away by 4 dm a metre. */
    private static final HeightField MESA = HeightField.of(new Vec3(-6, 0, -6), 0.2, 61, 61, (column, row) -> {
        double beside = Math.max(Math.abs(0.2 * column - 6) - 0.8, Math.abs(0.2 * row - 6) - 1.3);
        return 0.009 * ((column + row) % 2 == 0 ? 1 : -1) - 0.4 * Math.max(0, beside);
    });

    /** The portal on the ground, with its up axis to the north, leads to one at the foot of a wall. */
    private static PortalWorld world() {
        Vec3 on = new Vec3(0, HeightFieldSurface.y(MESA, 0, 0), 0);
        Portal ground =
                GroundSeat.over(MESA, on, "g", APERTURE, normal -> NORTH).portal();
        assertTrue(GroundSeat.stepMetres(List.of(MESA), ground) > 0.015, "the ground is uneven");
        Portal wall =
                new Portal("w", new Vec3(20, 1.05, 0), Portal.facing(new Vec3(0, 0, 1), new Vec3(0, 1, 0)), APERTURE);
        CollisionWorld statics = CollisionWorld.of(new StaticShapes(
                List.of(box("floor", new Vec3(20, -0.5, 0), 1, 10), box("wall", new Vec3(20, 5, -0.5), 10, 1)),
                PlacedModels.NONE,
                List.of(TestTerrain.grid("mesa", MESA))));
        return PortalWorld.of(statics, new Portals(List.of(ground, wall), List.of(1, 0)));
    }

    private static Brush box(String id, Vec3 centre, double height, double depth) {
        return Brush.of(
                new Solid.Box(id, null, true, TextureMapping.WORLD, centre, new Vec3(10, height, depth), Map.of()));
    }

    /**
     * Returns true where the floor before the wall lies, beyond the rim: it stands out of ground that falls away there, so
     * that bodies on their way through meet it.
     */
    private static boolean isOverTheFloorBeyond(double x, double z) {
        return z > 1.05 && (Math.abs(x) > 0.7 || z > 1.15);
    }

    /** Neither does the ground beside the aperture give way, nor do the other side's solids stand out of it. */
    @Test
    void aRayMeetsTheGroundBesideTheAperture() {
        CollisionWorld open = world().openedFor(1);
        RayCast cast = new RayCast();
        int beside = 0;
        int inside = 0;
        for (double x = -3; x <= 3; x += 0.13) {
            for (double z = -3.5; z <= 3.5; z += 0.17) {
                double out = APERTURE.outside(x, -z);
                if (Math.abs(out) < 0.01 || isOverTheFloorBeyond(x, z)) {
                    continue;
                }
                boolean isMet = cast.cast(open, new Ray(x, 2, z, 0, -1, 0), 8);
                double height = isMet ? 2 - cast.distance() : -6;
                if (out > 0) {
                    beside++;
                    assertEquals(HeightFieldSurface.y(MESA, x, z), height, 1e-6, x + " " + z);
                } else {
                    inside++;
                    assertTrue(height < -1, "open at " + x + " " + z);
                }
            }
        }
        assertTrue(beside > 1000 && inside > 80, beside + " " + inside);
    }
}
