package nephele.engine.render.pass.shadow;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.TracedLevel;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.LightParts;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.FrameState.Posture;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.engine.scene.dynamic.CharacterPresence;
import nephele.engine.scene.light.bake.FormulaLight;
import nephele.engine.scene.light.bake.IndirectLight;
import nephele.engine.scene.light.bake.IndirectLight.Course;
import nephele.engine.scene.light.bake.IndirectLight.SkyLight;
import nephele.lab.bake.TracedPictures;
import org.junit.jupiter.api.Test;

/** Moving objects darken the ambient light of what is near them as the traced picture does, and nothing else. */
class ContactGlTest {
    private static final int WIDTH = 48;
    private static final int HEIGHT = 32;
    private static final int GREEN = 1;
    private static final Quality ON = Quality.HIGH;
    private static final Quality OFF = Quality.HIGH.with("contact", Quality.Contact.OFF);

    /** Returns a green floor under an even sky, and a material without green. */
    private static TestLevel floor() {
        return new TestLevel()
                .skyLight()
                .sky(new Sky.Constant(TestLevel.grey(1)))
                .material("floor", new Vec3(0, 1, 0))
                .material("red", new Vec3(1, 0, 0))
                .box("floor", new Vec3(0, -0.5, 0), new Vec3(40, 1, 40));
    }

    private static TestLevel withBody(String kind, double centreY) {
        Vec3 centre = new Vec3(0, centreY, 0);
        return kind.equals("box")
                ? floor().cube("red", centre, 0.6)
                : floor().body(new Body.Sphere("ball", centre, 0.3, 10, "red", 0.6, 0));
    }

    /** Returns a level with the light of an open sky baked. */
    private static Scene baked(Level level) {
        PlacedLevel placed = PlacedLevel.of(level, new TestAssets());
        return Scene.of(
                placed,
                new FormulaLight(placed.statics())
                        .layer("", Course.INDIRECT, place -> TestLevel.grey(1), new Vec3(0, 1, 0).scaled(2 / 3.0))
                        .baked(SkyLight.BAKED));
    }

    private static float[] green(Offscreen offscreen, Level level, View view, Quality quality) {
        RenderSettings settings = RenderSettings.of(Output.HDR, quality);
        try (Renderer renderer = LevelRenderer.load(offscreen.gl, baked(level), settings)) {
            renderer.draw(view, offscreen.picture);
            offscreen.gl.requireNoError("contact");
            return green(renderer.readRadiance());
        }
    }

    private static float[] green(float[] rgb) {
        float[] green = new float[rgb.length / 3];
        for (int i = 0; i < green.length; i++) {
            green[i] = rgb[3 * i + GREEN];
        }
        return green;
    }

    private static double meanDifference(float[] a, float[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += Math.abs(a[i] - b[i]) / a.length;
        }
        return sum;
    }

    private static boolean darkens(TestLevel built, CharacterPresence character, boolean isBaked) {
        Scene scene = baked(built.level());
        IndirectLight light = isBaked ? scene.light().indirect() : null;
        return FrameRequest.of(scene.level(), scene.statics(), light, Output.HDR, ON, character)
                .drawsContact();
    }

    @Test
    void theFloorDarkensAsTheTracedOne() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            View view = offscreen.view(new Vec3(0.5, 1.2, 1.1), new Vec3(0, 0.1, 0));
            for (String kind : List.of("sphere", "box")) {
                for (double gap : new double[] {0, 0.05}) {
                    Level level = withBody(kind, 0.3 + gap).level();
                    TracedLevel twin = TracedLevel.of(PlacedLevel.of(level, new TestAssets()), ColourDecoding.SRGB);
                    float[] traced = green(ReferencePicture.trace(
                            twin, TracedPictures.pinhole(view), new TraceSettings(WIDTH, HEIGHT, 128, 1, 2), d -> {}));
                    double on = meanDifference(traced, green(offscreen, level, view, ON));
                    double off = meanDifference(traced, green(offscreen, level, view, OFF));
                    String what = kind + " " + gap + " m above: " + on + " with, " + off + " without";
                    assertTrue(on < (kind.equals("box") ? 0.45 : 0.2) * off, what);
                }
            }
        }
    }

    @Test
    void directLightIsUnchanged() {
        Level level = withBody("box", 0.3).sun(new Vec3(0.3, 1, 0.2), 2).level();
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            View view = offscreen.view(new Vec3(0.5, 1.2, 1.1), new Vec3(0, 0.1, 0));
            for (LightParts part : List.of(LightParts.DIFFUSE, LightParts.SPECULAR)) {
                float[] on = green(offscreen, level, view, ON.with("lightParts", part));
                assertArrayEquals(green(offscreen, level, view, OFF.with("lightParts", part)), on, part + "");
            }
            assertTrue(meanDifference(green(offscreen, level, view, OFF), green(offscreen, level, view, ON)) > 0.01);
        }
    }

    /** Nothing is drawn differently where nothing moves or no light is baked, nor far from everything that moves. */
    @Test
    void withoutMovingObjectsOrBakedLightNothingChanges() {
        assertFalse(darkens(floor(), CharacterPresence.NEVER, true));
        assertTrue(darkens(floor(), CharacterPresence.POSSIBLE, true));
        assertTrue(darkens(floor().cube("red", Vec3.ZERO, 1), CharacterPresence.NEVER, true));
        assertFalse(darkens(floor().cube("red", Vec3.ZERO, 1), CharacterPresence.POSSIBLE, false));
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            View away = offscreen.view(new Vec3(15, 1, 15), new Vec3(18, 0, 18));
            Level level = withBody("box", 0.3).level();
            assertArrayEquals(green(offscreen, level, away, OFF), green(offscreen, level, away, ON));
        }
    }

    /** A body halfway through a portal darkens the floors on both sides of it. */
    @Test
    void anImageBehindAPortalDarkensToo() {
        Level level = floor().box("floor", new Vec3(0, 2, -0.5), new Vec3(4, 4, 1))
                .box("floor", new Vec3(12, 2, -0.5), new Vec3(4, 4, 1))
                .portal("a", "b", new Vec3(0, 1, 0), new Vec3(0, 0, 1), 1, 2)
                .portal("b", "a", new Vec3(12, 1, 0), new Vec3(0, 0, 1), 1, 2)
                .cube("red", new Vec3(0, 0.3, 0.1), 0.6)
                .level();
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            for (double x : new double[] {0, 12}) {
                View view = offscreen.view(new Vec3(x, 1.2, 1.5), new Vec3(x, 0.1, 0.2));
                double darker = meanDifference(green(offscreen, level, view, OFF), green(offscreen, level, view, ON));
                assertTrue(darker > 0.003, "at " + x + " m by " + darker);
            }
        }
    }

    @Test
    void theCharacterDarkensTheFloorAroundItsFeet() {
        Level level = floor().level();
        double[] floor = new double[2];
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            View view = offscreen.view(new Vec3(0, 0.6, 0.8), new Vec3(0, 0, 0.1));
            for (int i = 0; i < 2; i++) {
                RenderSettings settings =
                        RenderSettings.of(Output.HDR, i == 0 ? OFF : ON).with(CharacterPresence.POSSIBLE);
                try (var renderer = LevelRenderer.load(offscreen.gl, baked(level), settings)) {
                    FrameState state = FrameState.atStart(level);
                    state.character(new Posture(new Vec3(0, 0.9, 0), new Vec3(0, 1, 0), 0, 0, 1.8, 0, 0, 0, 0, 0));
                    renderer.draw(view, state, offscreen.picture);
                    // In front of the toes.
                    floor[i] = green(renderer.readRadiance())[WIDTH * (HEIGHT / 2 - 3) + WIDTH / 2];
                }
            }
        }
        assertEquals(0.9, floor[1] / floor[0], 0.09, "share of light left");
    }
}
