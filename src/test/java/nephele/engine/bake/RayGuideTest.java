package nephele.engine.bake;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.asset.TestAssets;
import nephele.engine.bake.RayGuide.Aim;
import nephele.engine.level.TestLevel;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.bake.LightMapLayout;
import org.junit.jupiter.api.Test;

/** Guided rays go where light comes from and change no mean. */
class RayGuideTest {
    private static final int RAYS = 100_000;

    /** The part of the unit square from which light comes. */
    private static final double DOOR_U = 0.3;

    private static final double DOOR_V = 0.9;

    private static double light(Aim aim) {
        return aim.u() < DOOR_U && aim.v() > DOOR_V ? 7 : 0;
    }

    private static RayGuide guide() {
        StaticShapes statics = PlacedLevel.of(
                        new TestLevel().box("", Vec3.ZERO, new Vec3(10, 10, 10)).level(), TestAssets.NONE)
                .statics();
        return new RayGuide(new Receivers(LightMapLayout.of(statics.solids()), statics));
    }

    private static RayGuide taught() {
        RayGuide guide = guide();
        for (int ray = 0; ray < 1000; ray++) {
            Aim aim = Aim.even(1, ray);
            guide.learn(0, aim, light(aim));
        }
        guide.finish();
        return guide;
    }

    @Test
    void guidedRaysHaveTheSameMean() {
        RayGuide guide = taught();
        double sum = 0;
        double weights = 0;
        for (int ray = 0; ray < RAYS; ray++) {
            Aim aim = guide.guided(0, Aim.even(2, ray));
            assertTrue(aim.u() >= 0 && aim.u() < 1 && aim.v() >= 0 && aim.v() < 1, "outside of the square: " + aim);
            sum += light(aim) * aim.weight();
            weights += aim.weight();
        }
        assertEquals(7 * DOOR_U * (1 - DOOR_V), sum / RAYS, 0.002);
        assertEquals(1, weights / RAYS, 0.002);
    }

    @Test
    void mostRaysMeetTheLightAndNoneCountsForMany() {
        RayGuide guide = taught();
        int met = 0;
        double greatest = 0;
        for (int ray = 0; ray < RAYS; ray++) {
            Aim aim = guide.guided(1, Aim.even(3, ray));
            met += light(aim) > 0 ? 1 : 0;
            greatest = Math.max(greatest, aim.weight());
        }
        assertTrue(met > 0.4 * RAYS, met + " rays met the light, of which even ones would have met 3,000");
        assertTrue(greatest <= 2.5, "weight " + greatest);
    }

    @Test
    void whereNothingWasMetRaysStayEven() {
        RayGuide guide = taught();
        int far = 20; // beyond the square of texels that learned
        for (int ray = 0; ray < 100; ray++) {
            Aim even = Aim.even(4, ray);
            Aim guided = guide.guided(far, even);
            assertEquals(even.u(), guided.u(), 1e-12);
            assertEquals(even.v(), guided.v(), 1e-12);
            assertEquals(1, guided.weight(), 1e-12);
        }
    }
}
