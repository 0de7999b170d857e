package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Light;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.math.Vec3;
import nephele.engine.scene.View;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** Punctual lights on a floor equal inverse square, cosine, range and cone in double precision, pixel by pixel. */
class PunctualLightGlTest {
    private static final int SIZE = 64;
    private static final double ALBEDO = 0.5;
    private static final Vec3 EYE = new Vec3(0.3, 6, 0.2);

    @Test
    void inverseSquareAndRange() {
        assertFloorIsLitBy(List.of(
                new Light.Point("far", new Vec3(0.5, 1.5, -0.7), new Vec3(3, 2, 1), 1e6, false),
                new Light.Point("near", new Vec3(-3, 0.5, 2), new Vec3(1, 1, 1), 2.5, false)));
    }

    @Test
    void coneAndItsRim() {
        assertFloorIsLitBy(List.of(
                new Light.Spot("soft", new Vec3(1, 3, 0), new Vec3(0.2, -1, 0.1), grey(9), 20, 10, 30, false),
                new Light.Spot("sharp", new Vec3(-3, 2, -1), new Vec3(0, -1, 0.4), grey(4), 20, 25, 25.5, false)));
    }

    /** Lights in the floor, without range, immensely strong or immensely far give finite numbers. */
    @Test
    void degenerateLightsLeaveNumbers() {
        List<Light> lights = List.of(
                new Light.Point("on-the-floor", new Vec3(0, 0, 0), grey(5), 4, true),
                new Light.Point("in-the-floor", new Vec3(1, -0.5, 0), grey(5), 4, true),
                new Light.Point("no-range", new Vec3(0, 1, 0), grey(5), 0, true),
                new Light.Point("blinding", new Vec3(2, 1e-3, 1), grey(1e9), 1e9, true),
                new Light.Spot("needle", new Vec3(0, 2, 0), new Vec3(0, -1, 0), grey(1e9), 1e-2, 0, 0.1, true),
                new Light.Point("nowhere", new Vec3(Double.NaN, 1, 1), grey(5), 5, true));
        float[] rgb = draw(lights, 0.05);
        float brightest = 0;
        for (int i = 0; i < rgb.length; i++) {
            assertTrue(rgb[i] >= 0 && rgb[i] <= 65504, "component " + i + " is " + rgb[i]);
            brightest = Math.max(brightest, rgb[i]);
        }
        assertTrue(brightest > 1000, "the blinding lamp shows: " + brightest);
    }

    /** The picture has the sum over all lights, although a pixel evaluates only those of its grid cell. */
    @Test
    void aThousandLightsAddUp() {
        SplittableRandom random = new SplittableRandom(1000);
        List<Light> lights = new ArrayList<>();
        for (int i = 0; i < 1000; i++) {
            Vec3 p =
                    new Vec3(random.nextDouble() * 18 - 9, 0.2 + 3 * random.nextDouble(), random.nextDouble() * 18 - 9);
            double range = 0.5 + random.nextDouble() * 4;
            lights.add(
                    i % 3 == 0
                            ? new Light.Spot("s" + i, p, new Vec3(0.3, -1, 0.2), grey(0.1), range, 20, 40, false)
                            : new Light.Point("p" + i, p, grey(0.03), range, false));
        }
        assertFloorIsLitBy(lights);
    }

    private static void assertFloorIsLitBy(List<Light> lights) {
        float[] rgb = draw(lights, -1);
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x++) {
                Vec3 p = floorAt(x, y);
                Vector3d expected = lambert(lights, p);
                for (int c = 0; c < 3; c++) {
                    float drawn = rgb[3 * (y * SIZE + x) + c];
                    // Half floats keep 11 bits; the rest is the ramp of a cone over a float's cosine.
                    double tolerance = expected.get(c) * 4e-3 + 2e-4;
                    assertEquals(
                            expected.get(c), drawn, tolerance, "pixel " + x + ", " + y + " sees the floor at " + p);
                }
            }
        }
    }

    private static Vector3d lambert(List<Light> lights, Vec3 p) {
        Vector3d sum = new Vector3d();
        for (Light written : lights) {
            PunctualLight light = PunctualLight.of(written).orElseThrow();
            Vector3d toLight = light.position().toVector().sub(p.toVector()).normalize();
            sum.add(light.irradianceAt(p).mul(Math.max(toLight.y, 0) * ALBEDO / Math.PI));
        }
        return sum;
    }

    /** Returns the point of the floor y = 0 under a pixel's centre in a view straight down. */
    private static Vec3 floorAt(int x, int y) {
        double right = 2 * (x + 0.5) / SIZE - 1;
        double up = 2 * (y + 0.5) / SIZE - 1;
        return new Vec3(EYE.x() + EYE.y() * right, 0, EYE.z() - EYE.y() * up);
    }

    /** @param metalRoughness negative for a Lambertian floor */
    private static float[] draw(List<Light> lights, double metalRoughness) {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            TestLevel level = new TestLevel().box("m", new Vec3(0, -0.5, 0), new Vec3(40, 1, 40));
            // A tower, so that the grid has cells above and below the floor.
            level.box("m", new Vec3(15, 4, 15), new Vec3(1, 16, 1));
            if (metalRoughness < 0) {
                level.material("m", grey(ALBEDO));
            } else {
                level.material(new nephele.engine.level.Material(
                        "m", grey(ALBEDO), null, metalRoughness, 1.0, null, Vec3.ZERO, 1));
            }
            lights.forEach(level::light);
            View view = View.lookAt(
                    EYE,
                    new Vec3(EYE.x(), 0, EYE.z()),
                    new Vec3(0, 0, -1),
                    offscreen.view(EYE, Vec3.ZERO).projection());
            return offscreen.radiance(level.level(), TestAssets.NONE, view);
        }
    }

    private static Vec3 grey(double value) {
        return TestLevel.grey(value);
    }
}
