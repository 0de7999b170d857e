package nephele.engine.scene.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.level.Brush;
import nephele.engine.level.Light;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.bake.Occluders;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** A punctual light's irradiance depends on distance, range and cone, and its grid lists are complete. */
@Execution(ExecutionMode.CONCURRENT)
class PunctualLightTest {
    private static final Vec3 WHITE = new Vec3(1, 1, 1);

    @Test
    void irradianceFallsWithTheSquareFarInsideTheRange() {
        PunctualLight light = point(new Vec3(0, 0, 0), 1e6);
        for (double d : new double[] {0.1, 1, 2, 10, 100}) {
            assertEquals(1 / (d * d), light.irradianceAt(new Vec3(d, 0, 0)).x, 1e-9 / (d * d), d + " m away");
        }
    }

    @Test
    void nothingArrivesAtOrBeyondTheRange() {
        PunctualLight light = point(Vec3.ZERO, 5);
        assertEquals(0, light.irradianceAt(new Vec3(0, 5, 0)).x);
        assertEquals(0, light.irradianceAt(new Vec3(1e9, 1e9, 0)).x);
        assertTrue(light.irradianceAt(new Vec3(0, 4.9, 0)).x < 1e-3, "the window ends smoothly");
    }

    @Test
    void nearerThanACentimetreNothingGrows() {
        PunctualLight light = point(Vec3.ZERO, 5);
        assertEquals(1e4, light.irradianceAt(Vec3.ZERO).x, 1e-3);
        assertEquals(1e4, light.irradianceAt(new Vec3(1e-160, 0, 0)).x, 1e-3);
    }

    @Test
    void lightsThatLightNothingAreDropped() {
        double nan = Double.NaN;
        Vec3 p = new Vec3(1, 2, 3);
        List<Light> useless = List.of(
                new Light.Point("no-range", p, WHITE, 0, true),
                new Light.Point("negative", p, WHITE, -3, true),
                new Light.Point("nan-range", p, WHITE, nan, true),
                new Light.Point("nan-colour", p, new Vec3(nan, nan, nan), 5, true),
                new Light.Point("dark", p, Vec3.ZERO, 5, true),
                new Light.Point("nowhere", new Vec3(nan, 0, 0), WHITE, 5, true),
                new Light.Spot("no-axis", p, Vec3.ZERO, WHITE, 5, 10, 20, true),
                new Light.Spot("no-cone", p, WHITE, WHITE, 5, 0, 0, true),
                new Light.Spot("nan-cone", p, WHITE, WHITE, 5, nan, nan, true));
        for (Light light : useless) {
            assertTrue(PunctualLight.of(light).isEmpty(), light.id());
        }
    }

    @Test
    void extremeLightsPackIntoFiniteFloats() {
        List<Light> lights = List.of(
                new Light.Point("strong", Vec3.ZERO, new Vec3(1e300, 1, 0), 1e300, true),
                new Light.Point("short", Vec3.ZERO, WHITE, 1e-3, true),
                new Light.Spot("needle", Vec3.ZERO, new Vec3(0, 1e-200, 0), WHITE, 9, 1e-9, 1e-9, true),
                new Light.Spot("all-around", Vec3.ZERO, new Vec3(0, -1, 0), WHITE, 9, 500, 900, true));
        PunctualLightTable table =
                PunctualLightTable.of(lights, new Aabb(-1, -1, -1, 1, 1, 1), StaticShapes.of(List.of()));
        for (float f : table.packed(Vec3.ZERO)) {
            assertTrue(Float.isFinite(f), Arrays.toString(table.packed(Vec3.ZERO)));
        }
    }

    @Test
    void spotIsFullInsideItsInnerConeAndDarkOutsideItsOuterOne() {
        PunctualLight light = PunctualLight.of(
                        new Light.Spot("s", Vec3.ZERO, new Vec3(0, -2, 0), WHITE, 1e6, 20, 30, false))
                .orElseThrow();
        for (double degrees = 0; degrees < 60; degrees += 1.7) {
            double angle = Math.toRadians(degrees);
            double e = light.irradianceAt(new Vec3(Math.sin(angle), -Math.cos(angle), 0)).x;
            if (degrees < 19.9) {
                assertEquals(1, e, 1e-6, degrees + "° from the axis");
            } else if (degrees > 30.1) {
                assertEquals(0, e, degrees + "° from the axis");
            }
        }
    }

    /** Every light that reaches a point is in the point's list, inside the grid and far outside of it. */
    @Test
    void gridListsEveryLightThatArrives() {
        SplittableRandom random = new SplittableRandom(44);
        List<Light> lights = randomLights(random, 1000);
        PunctualLightTable table =
                PunctualLightTable.of(lights, new Aabb(-30, -2, -20, 30, 8, 20), StaticShapes.of(List.of()));
        long listed = 0;
        for (int i = 0; i < 2000; i++) {
            double spread = i % 4 == 0 ? 90 : 32;
            Vec3 p = new Vec3(
                    (random.nextDouble() - 0.5) * 2 * spread,
                    random.nextDouble() * 12 - 3,
                    (random.nextDouble() - 0.5) * 2 * spread);
            Vec3 normal = normal(random, i);
            int list = LightGrid.FACINGS * cellAt(table.grid(), p) + facingOf(normal);
            int from = table.grid().firstOfList()[list];
            int to = table.grid().firstOfList()[list + 1];
            listed += to - from;
            assertSame(brute(table, p, normal), fromList(table, p, normal, from, to), p);
        }
        assertTrue(listed < 2000 * 300, "lists are short: " + listed / 2000 + " of 1000 lamps on average");
    }

    private static void assertSame(Vector3d all, Vector3d listed, Vec3 p) {
        assertEquals(0, all.distance(listed), 1e-12, "light at " + p + " is missing lamps");
    }

    /** Returns a normal along an axis or an arbitrary one. */
    private static Vec3 normal(SplittableRandom random, int i) {
        double sign = (i & 1) == 0 ? 1 : -1;
        return switch (i % 7) {
            case 0 -> new Vec3(sign, 0, 0);
            case 1 -> new Vec3(0, sign, 0);
            case 2 -> new Vec3(0, 0, sign);
            default -> {
                Vector3d n = new Vector3d(random.nextDouble() - 0.5, random.nextDouble() - 0.5, 0.5 * sign).normalize();
                yield new Vec3(n.x, n.y, n.z);
            }
        };
    }

    private static Vector3d onFace(PunctualLight light, Vec3 p, Vec3 normal) {
        double cosine = light.position().toVector().sub(p.toVector()).dot(normal.toVector());
        return cosine > 0 ? light.irradianceAt(p) : new Vector3d();
    }

    private static Vector3d brute(PunctualLightTable table, Vec3 p, Vec3 normal) {
        Vector3d sum = new Vector3d();
        table.lights().forEach(light -> sum.add(onFace(light, p, normal)));
        return sum;
    }

    private static Vector3d fromList(PunctualLightTable table, Vec3 p, Vec3 normal, int from, int to) {
        Vector3d sum = new Vector3d();
        for (int i = from; i < to; i++) {
            sum.add(onFace(table.lights().get(table.grid().lights()[i]), p, normal));
        }
        return sum;
    }

    private static List<Light> randomLights(SplittableRandom random, int count) {
        List<Light> lights = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            Vec3 p = new Vec3(random.nextDouble() * 80 - 40, random.nextDouble() * 8, random.nextDouble() * 60 - 30);
            double range = i % 50 == 0 ? 1e9 : 1 + random.nextDouble() * 7;
            Vec3 axis = new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5);
            double outer = 1 + random.nextDouble() * 170;
            lights.add(
                    i % 2 == 0
                            ? new Light.Point("p" + i, p, WHITE, range, i % 3 == 0)
                            : new Light.Spot("s" + i, p, axis, WHITE, range, outer / 2, outer, i % 3 == 0));
        }
        return lights;
    }

    /** A light omitted from a cell's list is hidden from every point of the cell by a solid. */
    @Test
    void hiddenLightsAreLeftOutAndNoOthers() {
        List<Brush> walls = List.of(
                ShadowTest.box(0, 1.5, 0, 0.3, 3, 10),
                ShadowTest.box(4, 1.5, 2, 8, 3, 0.3),
                ShadowTest.box(0, -0.2, 0, 20, 0.4, 20));
        List<Light> lights = List.of(
                new Light.Point("a", new Vec3(-2, 2, 1), WHITE, 30, true),
                new Light.Point("b", new Vec3(3, 2, -1), WHITE, 30, true),
                new Light.Point("through", new Vec3(3, 2, -1), WHITE, 30, false));
        PunctualLightTable table =
                PunctualLightTable.of(lights, StaticShapes.of(walls).bounds(), StaticShapes.of(walls));
        SplittableRandom random = new SplittableRandom(9);
        Occluders solids = new Occluders(walls);
        int leftOut = 0;
        for (int i = 0; i < 5000; i++) {
            Vec3 p = new Vec3(random.nextDouble() * 20 - 10, random.nextDouble() * 3, random.nextDouble() * 20 - 10);
            int list = LightGrid.FACINGS * cellAt(table.grid(), p) + LightGrid.FACINGS - 1;
            int[] listed = Arrays.copyOfRange(
                    table.grid().lights(),
                    table.grid().firstOfList()[list],
                    table.grid().firstOfList()[list + 1]);
            for (int light = 0; light < 3; light++) {
                int wanted = light;
                if (Arrays.stream(listed).noneMatch(l -> l == wanted)) {
                    Vector3d d = lights.get(light).position().toVector().sub(p.toVector());
                    double[] o = {p.x(), p.y(), p.z()};
                    assertTrue(solids.isOccluded(o, new double[] {d.x, d.y, d.z}, -1), light + " is seen from " + p);
                    leftOut++;
                }
            }
        }
        assertTrue(leftOut > 1000, "walls hide lamps: " + leftOut);
    }

    @Test
    void shadowLayersKeepToTheirBudget() {
        List<Light> lights = randomLights(new SplittableRandom(1), 1000);
        LightShadowLayers shadows = PunctualLightTable.of(
                        lights, new Aabb(-1, -1, -1, 1, 1, 1), StaticShapes.of(List.of()))
                .shadows();
        assertTrue((long) shadows.side() * shadows.side() * shadows.layers().size() <= 1 << 23);
        assertEquals(LightShadowLayers.MIN_SIDE_TEXELS, shadows.side());
        LightShadowLayers few = PunctualLightTable.of(
                        lights.subList(0, 4), new Aabb(-1, -1, -1, 1, 1, 1), StaticShapes.of(List.of()))
                .shadows();
        assertEquals(LightShadowLayers.MAX_SIDE_TEXELS, few.side());
    }

    private static PunctualLight point(Vec3 p, double range) {
        return PunctualLight.of(new Light.Point("p", p, WHITE, range, false)).orElseThrow();
    }

    /** Returns the cell of any point in space, as the shader computes it. */
    private static int cellAt(LightGrid grid, Vec3 p) {
        int x = index((p.x() - grid.min().x()) / grid.cellMetres().x(), grid.columns());
        int y = index((p.y() - grid.min().y()) / grid.cellMetres().y(), grid.floors());
        int z = index((p.z() - grid.min().z()) / grid.cellMetres().z(), grid.rows());
        return x + grid.columns() * (y + grid.floors() * z);
    }

    private static int index(double cell, int count) {
        return (int) Math.min(Math.max(cell, 0), count - 1);
    }

    /** Returns the index of a face's list in its cell, as the shader computes it. */
    private static int facingOf(Vec3 normal) {
        double limit = 0.9999;
        double[] n = {normal.x(), normal.y(), normal.z()};
        for (int axis = 0; axis < 3; axis++) {
            if (Math.abs(n[axis]) > limit) {
                return 2 * axis + (n[axis] < 0 ? 1 : 0);
            }
        }
        return LightGrid.FACINGS - 1;
    }
}
