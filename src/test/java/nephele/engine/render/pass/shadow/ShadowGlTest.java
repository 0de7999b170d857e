package nephele.engine.render.pass.shadow;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Stream;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.level.placed.NoFiles;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.FramePlan;
import nephele.engine.render.Offscreen;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import nephele.engine.scene.light.LightShadowLayers;
import nephele.engine.scene.light.ShadowCasters;
import nephele.engine.scene.light.ShadowFrame;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A shadow's edge is within one shadow texel of the edge that rays in double precision give. */
class ShadowGlTest {
    private static final int SIZE = 160;
    private static final Vec3 SLAB_MIN = new Vec3(-1, 1.4, -0.7);
    private static final Vec3 SLAB_MAX = new Vec3(0.6, 1.6, 0.9);
    private static final Vec3 EYE = new Vec3(0.4, 0.9, 0.3);

    private static TestLevel slabOverGround() {
        return new TestLevel()
                .material("m", TestLevel.grey(1))
                .box("m", new Vec3(0, -0.5, 0), new Vec3(30, 1, 30))
                .box("m", new Vec3(-0.2, 1.5, 0.1), new Vec3(1.6, 0.2, 1.6));
    }

    @Test
    void sunShadowEdgeLiesWithinOneTexel() {
        for (Vec3 sun :
                List.of(new Vec3(0, 1, 0), new Vec3(0.4, 1, 0.3), new Vec3(-0.8, 1, 0.5), new Vec3(0.2, 0.5, 0))) {
            Level level = slabOverGround().castingSun(sun, Math.PI).level();
            Vector3d towards = sun.toVector().normalize();
            ShadowFrame frame = frameOf(level, sun);
            assertTrue(frame.texelMetres() <= 0.0101, "texel " + frame.texelMetres() + " m: the ground is no caster");
            // A texel of the map, projected on the ground, is stretched by the sun's slope.
            double texel = frame.texelMetres() / towards.y;
            assertEdge(level, "sun " + sun, towards.y, texel, p -> meetsSlab(p, towards, 1e9));
        }
    }

    private static ShadowFrame frameOf(Level level, Vec3 sun) {
        List<Brush> brushes = level.solids().stream().map(Brush::of).toList();
        List<Vec3> corners = ShadowCasters.of(brushes, sun).stream()
                .flatMap(b -> b.shape().vertices().stream())
                .toList();
        return ShadowFrame.fit(corners, sun, Vec3.ZERO, Quality.HIGH.shadowTexels());
    }

    @Test
    void pointLightShadowEdgeLiesWithinOneTexel() {
        Vec3 light = new Vec3(-0.5, 2.6, 0.4);
        Level level = slabOverGround()
                .light(new Light.Point("l", light, TestLevel.grey(Math.PI * 9), 1e6, true))
                .level();
        assertLightEdge(level, light, 1);
    }

    @Test
    void spotShadowEdgeLiesWithinOneTexel() {
        Vec3 light = new Vec3(-0.9, 3.4, 1.2);
        Vec3 axis = new Vec3(0.25, -1, -0.3);
        Level level = slabOverGround()
                .light(new Light.Spot("l", light, axis, TestLevel.grey(Math.PI * 9), 1e6, 50, 50.1, true))
                .level();
        assertLightEdge(level, light, Math.tan(Math.toRadians(50)));
    }

    /** @param tangent half a picture's width at distance 1 */
    private static void assertLightEdge(Level level, Vec3 light, double tangent) {
        double distance = light.y() * 2.2;
        double texel = 2 * tangent * distance / LightShadowLayers.MAX_SIDE_TEXELS * 2;
        assertEdge(level, "lamp " + light, 0, texel, p -> {
            Vector3d to = light.toVector().sub(p.toVector());
            return meetsSlab(p, to, 1);
        });
    }

    /**
     * Pixels whose neighbourhood of one texel is completely in shadow are black; those without any shadow in it are
     * lit.
     */
    private static void assertEdge(
            Level level, String light, double litRadiance, double texel, Predicate<Vec3> shaded) {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            View view = View.lookAt(
                    EYE, new Vec3(EYE.x(), 0, EYE.z()), new Vec3(0, 0, -1), new Projection(2.2, 1, 0.01, 100));
            float[] rgb = offscreen.radiance(level, TestAssets.NONE, view);
            double half = EYE.y() * Math.tan(1.1);
            int black = 0;
            int lit = 0;
            for (int i = 0; i < SIZE * SIZE; i++) {
                double x = EYE.x() + half * (2 * (i % SIZE + 0.5) / SIZE - 1);
                double z = EYE.z() - half * (2 * (i / SIZE + 0.5) / SIZE - 1);
                String where = light + ", ground at " + x + ", " + z + ": radiance " + rgb[3 * i];
                double full = litRadiance > 0 ? litRadiance : lightRadiance(level, x, z);
                int near = shadedAround(x, z, texel, shaded);
                assertTrue(near < 9 || rgb[3 * i] < full / 2, "the edge is not here, this is shadow; " + where);
                assertTrue(near > 0 || rgb[3 * i] > full / 2, "the edge is not here, this is lit; " + where);
                int wide = shadedAround(x, z, 2 * texel, shaded);
                if (wide == 9) {
                    black++;
                    assertEquals(0, rgb[3 * i], "should be in shadow; " + where);
                } else if (wide == 0) {
                    lit++;
                    assertEquals(full, rgb[3 * i], full * 2e-3, "should be lit; " + where);
                }
            }
            assertTrue(black > 400 && lit > 400, light + ": the picture shows " + black + " dark, " + lit + " lit");
        }
    }

    private static double lightRadiance(Level level, double x, double z) {
        PunctualLight light = PunctualLight.of(level.lights().get(0)).orElseThrow();
        Vector3d to = light.position().toVector().sub(x, 0, z);
        return light.irradianceAt(new Vec3(x, 0, z)).x * to.y / to.length() / Math.PI;
    }

    private static int shadedAround(double x, double z, double texel, Predicate<Vec3> shaded) {
        int count = 0;
        for (int i = -1; i <= 1; i++) {
            for (int j = -1; j <= 1; j++) {
                count += shaded.test(new Vec3(x + i * texel, 0, z + j * texel)) ? 1 : 0;
            }
        }
        return count;
    }

    private static boolean meetsSlab(Vec3 p, Vector3d d, double length) {
        double enter = 0;
        double leave = length;
        for (int axis = 0; axis < 3; axis++) {
            double o = p.toVector().get(axis);
            double a = (SLAB_MIN.toVector().get(axis) - o) / d.get(axis);
            double b = (SLAB_MAX.toVector().get(axis) - o) / d.get(axis);
            enter = Math.max(enter, Math.min(a, b));
            leave = Math.min(leave, Math.max(a, b));
        }
        return enter < leave;
    }

    private static TestLevel room(double wall) {
        double outer = 4 + 2 * wall;
        return new TestLevel()
                .material("m", TestLevel.grey(1))
                .box("m", new Vec3(0, -0.25, 0), new Vec3(12, 0.5, 12))
                .box("m", new Vec3(-2 - wall / 2, 1.25, 0), new Vec3(wall, 2.5, outer))
                .box("m", new Vec3(2 + wall / 2, 1.25, 0), new Vec3(wall, 2.5, outer))
                .box("m", new Vec3(0, 1.25, -2 - wall / 2), new Vec3(4, 2.5, wall))
                .box("m", new Vec3(0, 1.25, 2 + wall / 2), new Vec3(4, 2.5, wall))
                .box("m", new Vec3(0, 2.5 + wall / 2, 0), new Vec3(outer, wall, outer));
    }

    /** No sun, sky or other light from outside leaks in at any joint of walls of 10 cm. */
    @ParameterizedTest
    @CsvSource({"0.3, 1, 0.2", "1, 0.4, -0.7", "-0.9, 0.15, 0.1"})
    void aClosedRoomIsDark(double x, double y, double z) {
        try (Offscreen offscreen = new Offscreen(96, 96)) {
            Level level = room(0.1)
                    .castingSun(new Vec3(x, y, z), 100)
                    .skyLight()
                    .sky(new Sky.Constant(TestLevel.grey(50)))
                    .light(new Light.Point("above", new Vec3(0.3, 3.2, 0.2), TestLevel.grey(500), 20, true))
                    .light(new Light.Point("beside", new Vec3(2.4, 0.6, 0.3), TestLevel.grey(500), 20, true))
                    .light(new Light.Spot(
                            "into", new Vec3(0, 1, 4), new Vec3(0, 0, -1), TestLevel.grey(500), 20, 40, 60, true))
                    .level();
            assertDark(offscreen, level);
        }
    }

    private static void assertDark(Offscreen offscreen, Level level) {
        List<Vec3> targets =
                List.of(new Vec3(2, 0, 2), new Vec3(-2, 2.5, -2), new Vec3(2, 2.5, -2), new Vec3(-2, 0, 2));
        List<View> views = targets.stream()
                .map(target -> offscreen.view(new Vec3(0, 1.2, 0), target))
                .toList();
        List<float[]> seen = offscreen.radiance(level, TestAssets.NONE, views);
        for (int i = 0; i < seen.size(); i++) {
            int lit = 0;
            for (float value : seen.get(i)) {
                lit += value > 0 ? 1 : 0;
            }
            assertEquals(0, lit, "looking at the corner " + targets.get(i) + ": lit components");
        }
    }

    /**
     * A punctual light inside an empty room lights every wall as without shadows: there is no seam between its six
     * pictures.
     */
    @Test
    void anEmptyRoomHasNoShadowsAndNoSeams() {
        try (Offscreen offscreen = new Offscreen(96, 96)) {
            Light.Point light = new Light.Point("l", new Vec3(0.21, 1.13, -0.37), TestLevel.grey(4), 20, true);
            Light.Point free = new Light.Point("l", light.position(), light.radiantIntensity(), 20, false);
            List<View> views = Stream.of(new Vec3(2, 0.4, 2), new Vec3(-2, 2.4, -2), new Vec3(2, 2, -2))
                    .map(target -> offscreen.view(new Vec3(0, 1.2, 0), target))
                    .toList();
            List<float[]> casting = offscreen.radiance(room(0.2).light(light).level(), TestAssets.NONE, views);
            List<float[]> plain = offscreen.radiance(room(0.2).light(free).level(), TestAssets.NONE, views);
            for (int i = 0; i < views.size(); i++) {
                assertAlikeAwayFromJoints(views.get(i), plain.get(i), casting.get(i));
            }
        }
    }

    private static void assertAlikeAwayFromJoints(View view, float[] plain, float[] casting) {
        for (int i = 0; i < casting.length; i += 3) {
            if (distanceToJoint(view, i / 3 % 96, i / 3 / 96) > 0.005) {
                String where = "pixel " + i / 3 % 96 + ", " + i / 3 / 96 + " of " + view;
                assertEquals(plain[i], casting[i], plain[i] * 2e-3, where);
            }
        }
    }

    /**
     * Returns the distance from a pixel's point in the room to the next wall: within a filter's width of a joint, the
     * walls may shade each other.
     */
    private static double distanceToJoint(View view, int x, int y) {
        Vector3d d = view.right().toVector().mul((x + 0.5) / 48 - 1);
        d.fma((y + 0.5) / 48 - 1, view.up().toVector()).sub(view.back().toVector());
        double[] low = {-2, 0, -2};
        double[] high = {2, 2.5, 2};
        double t = Double.MAX_VALUE;
        for (int axis = 0; axis < 3; axis++) {
            double wall = d.get(axis) > 0 ? high[axis] : low[axis];
            t = Math.min(t, (wall - view.eye().toVector().get(axis)) / d.get(axis));
        }
        Vector3d p = view.eye().toVector().fma(t, d);
        double[] toWalls = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            toWalls[axis] = Math.min(p.get(axis) - low[axis], high[axis] - p.get(axis));
        }
        Arrays.sort(toWalls);
        return toWalls[1];
    }

    @Test
    void withoutACauseThereIsNoShadowPass() {
        assertTrue(names(slabOverGround().castingSun(new Vec3(0, 1, 0), 1)).contains("shadow.sun"));
        assertFalse(names(slabOverGround().sun(new Vec3(0, 1, 0), 1)).contains("shadow.sun"), "castsShadow: false");
        TestLevel alone =
                new TestLevel().box(null, Vec3.ZERO, TestLevel.grey(1)).castingSun(new Vec3(0, 1, 0), 1);
        assertFalse(names(alone).contains("shadow.sun"), "one convex solid shades nothing");
        Light casting = new Light.Point("l", new Vec3(0, 2, 0), TestLevel.grey(1), 5, true);
        Light free = new Light.Point("l", new Vec3(0, 2, 0), TestLevel.grey(1), 5, false);
        Light dark = new Light.Point("l", new Vec3(0, 2, 0), TestLevel.grey(1), 0, true);
        assertTrue(names(slabOverGround().light(casting)).contains("shadow.lights"));
        assertFalse(names(slabOverGround().light(free)).contains("shadow.lights"), "castsShadow: false");
        assertFalse(names(slabOverGround().light(dark)).contains("shadow.lights"), "a lamp without range");
        Sky sky = new Sky.Constant(TestLevel.grey(1));
        assertTrue(names(slabOverGround().sky(sky).skyLight()).contains("sky-visibility"));
        assertFalse(names(slabOverGround().sky(sky)).contains("sky-visibility"), "an ambient constant");
        assertFalse(names(slabOverGround().skyLight()).contains("sky-visibility"), "no sky");
    }

    private static List<String> names(TestLevel level) {
        return FramePlan.of(FrameRequest.of(PlacedLevel.of(level.level(), NoFiles.AT_ALL), Output.DIRECT))
                .steps()
                .stream()
                .filter(step -> !step.required().isEmpty())
                .map(step -> step.feature().name())
                .toList();
    }
}
