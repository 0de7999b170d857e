package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.RenderSettings.Narrowing;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.gl.BareFrame;
import nephele.engine.render.gl.GlKind;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.resource.OpeningMesh;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.engine.scene.dynamic.CharacterPresence;
import org.junit.jupiter.api.Test;

/** The stages of a frame are in order, and passes after opaque surfaces read copies of their view. */
class StageGlTest {
    private static final int SIDE = 64;

    /**
     * Returns a wall 4 m away with a portal; 6 m behind its exit another wall with another portal, 2 m behind whose
     * exit a third.
     */
    private static TestLevel walls() {
        return new TestLevel()
                .ambient(1)
                .material("wall", new Vec3(0.2, 0.6, 0.4))
                .box("wall", new Vec3(0, 0, -4.5), new Vec3(12, 12, 1))
                .box("wall", new Vec3(26.5, 0, 0), new Vec3(1, 30, 30))
                .box("wall", new Vec3(42.5, 0, 0), new Vec3(1, 30, 30))
                .portal("a", "b", new Vec3(0, 0, -4), new Vec3(0, 0, 1), 4, 4)
                .portal("b", "a", new Vec3(20, 0, 0), new Vec3(1, 0, 0), 4, 4)
                .portal("c", "d", new Vec3(26, 0, 0), new Vec3(-1, 0, 0), 3, 3)
                .portal("d", "c", new Vec3(40, 0, 0), new Vec3(1, 0, 0), 3, 3);
    }

    private static Level threeWalls() {
        return walls().level();
    }

    @Test
    void aPassGetsOnlyWhatItsFeatureNames() {
        RenderFeature feature = new RenderFeature(
                "curious",
                Stage.IN_VIEWS,
                request -> List.of(new Required("trial", context -> {
                    context.get(OpeningMesh.RESOURCE);
                    return frame -> {};
                })));
        Scene scene = Scene.of(threeWalls(), TestAssets.NONE);
        RenderSettings settings = RenderSettings.of(Output.DIRECT);
        try (Offscreen offscreen = new Offscreen(SIDE, SIDE)) {
            assertThrows(
                    IllegalStateException.class,
                    () -> LevelRenderer.load(offscreen.gl, scene, settings, List.of(feature)));
            LevelRenderer.load(offscreen.gl, scene, settings, List.of(feature.using(OpeningMesh.RESOURCE)))
                    .close();
        }
    }

    private static View view(Offscreen offscreen) {
        return offscreen.view(Vec3.ZERO, new Vec3(0, 0, -1));
    }

    private static List<RenderFeature> withTrial(Stage stage) {
        List<RenderFeature> features = new ArrayList<>(RenderFeatures.ALL);
        int afterAll = (int) features.stream()
                .filter(feature -> feature.stage() != Stage.AFTER_ALL)
                .count();
        features.add(afterAll, DistancePass.of(stage));
        return features;
    }

    private static Renderer trial(Offscreen offscreen, Level level, RenderSettings settings) {
        Scene scene = Scene.of(level, TestAssets.NONE);
        return LevelRenderer.load(offscreen.gl, scene, settings, withTrial(Stage.IN_VIEWS_AFTER_OPAQUE));
    }

    private static RenderSettings settings(Quality quality) {
        return RenderSettings.of(Output.PLAIN, quality).with(Decoration.OFF);
    }

    private static Quality technique(PortalTechnique technique) {
        return Quality.HIGH.with("viewBudget", 6).with("portalTechnique", technique);
    }

    @Test
    void aPassReadsTheViewThatItIsDrawnIn() {
        List<RenderSettings> all = new ArrayList<>();
        for (PortalTechnique technique : PortalTechnique.values()) {
            all.add(settings(technique(technique).with("samples", 4)));
        }
        all.add(settings(technique(PortalTechnique.TEXTURE).with("portalResolution", 0.5)));
        all.add(settings(Quality.HIGH.with("viewBudget", 6)));
        all.add(settings(Quality.HIGH.with("viewBudget", 6)).with(Narrowing.OFF));
        try (Offscreen offscreen = new Offscreen(SIDE, SIDE)) {
            for (RenderSettings each : all) {
                try (Renderer renderer = trial(offscreen, threeWalls(), each)) {
                    renderer.draw(view(offscreen), offscreen.picture);
                    offscreen.gl.requireNoError("trial");
                    assertShows(offscreen.pixels(), each.toString());
                }
            }
        }
    }

    private static void assertShows(int[] pixels, String settings) {
        assertPixel(pixels, 4, SIDE / 2, 4 / 16.0, 0.2, 0.6, settings);
        assertPixel(pixels, SIDE / 2, SIDE - 4, 4 / 16.0, 0.2, 0.6, settings);
        assertPixel(pixels, 20, SIDE / 2, 4 / 16.0, 10 / 16.0, 0.2, settings);
        assertPixel(pixels, SIDE / 2, 44, 4 / 16.0, 10 / 16.0, 0.2, settings);
        assertPixel(pixels, SIDE / 2, SIDE / 2, 4 / 16.0, 10 / 16.0, 12 / 16.0, settings);
    }

    private static void assertPixel(int[] pixels, int x, int y, double red, double green, double blue, String where) {
        int rgb = pixels[y * SIDE + x];
        String at = where + " at " + x + ", " + y;
        assertEquals(255 * red, Offscreen.red(rgb), 1.01, at);
        assertEquals(255 * green, Offscreen.green(rgb), 1.01, at);
        assertEquals(255 * blue, Offscreen.blue(rgb), 1.01, at);
    }

    @Test
    void itReadsTheLinearPictureToo() {
        try (Offscreen offscreen = new Offscreen(SIDE, SIDE);
                Renderer renderer = trial(
                        offscreen,
                        threeWalls(),
                        RenderSettings.of(
                                        Output.HDR,
                                        Quality.HIGH.with("viewBudget", 6).with("samples", 4))
                                .with(Decoration.OFF))) {
            renderer.draw(view(offscreen), offscreen.picture);
            float[] radiance = renderer.readRadiance();
            int middle = 3 * (SIDE / 2 * SIDE + SIDE / 2);
            assertEquals(4 / 16.0, radiance[middle], 1e-3);
            assertEquals(10 / 16.0, radiance[middle + 1], 1e-3);
            assertEquals(12 / 16.0, radiance[middle + 2], 1e-3);
        }
    }

    private static List<String> copies(Offscreen offscreen, Renderer renderer) {
        try (BareFrame frame =
                BareFrame.record(offscreen.gl, () -> renderer.draw(view(offscreen), offscreen.picture))) {
            return frame.words().stream()
                    .filter(word -> word.startsWith("copy "))
                    .toList();
        }
    }

    /**
     * There is one copy for each view if a pass reads it; no copy and no texture if the pass there, for held bodies,
     * does not.
     */
    @Test
    void onlyWhatIsReadIsCopied() {
        Level level = walls().cube("wall", new Vec3(0, 0, 9), 0.5).level();
        RenderSettings played = settings(Quality.HIGH.with("viewBudget", 6)).with(CharacterPresence.POSSIBLE);
        try (Offscreen offscreen = new Offscreen(SIDE, SIDE)) {
            try (Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, played)) {
                var loaded = offscreen.gl.live().counts();
                assertEquals(List.of(), copies(offscreen, renderer));
                assertEquals(2, renderer.viewsDrawn());
                for (GlKind kind : List.of(GlKind.TEXTURE, GlKind.FRAMEBUFFER, GlKind.RENDERBUFFER)) {
                    assertEquals(loaded.get(kind), offscreen.gl.live().counts().get(kind), kind.name());
                }
            }
            try (Renderer renderer = trial(offscreen, level, played)) {
                List<String> copies = copies(offscreen, renderer);
                assertEquals(1 + renderer.viewsDrawn(), copies.size());
                assertTrue(
                        copies.stream().allMatch(word -> word.startsWith("copy COLOUR_AND_DEPTH ")), copies::toString);
            }
        }
    }

    @Test
    void copiesAreClosedWithTheLevel() {
        try (Offscreen offscreen = new Offscreen(SIDE, SIDE)) {
            var before = offscreen.gl.live().counts();
            try (Renderer renderer = trial(offscreen, threeWalls(), settings(technique(PortalTechnique.TEXTURE)))) {
                renderer.draw(view(offscreen), offscreen.picture);
            }
            assertEquals(before, offscreen.gl.live().counts());
        }
    }

    /** The bare twin repeats the copies. */
    @Test
    void theBareTwinReadsItsViewsToo() {
        try (Offscreen offscreen = new Offscreen(SIDE, SIDE);
                Renderer renderer = trial(offscreen, threeWalls(), settings(Quality.HIGH.with("viewBudget", 6)));
                BareTwin twin = new BareTwin(offscreen.gl, renderer, List.of(view(offscreen)), offscreen.picture)) {
            offscreen.picture.clear(1, 0, 1);
            twin.draw(0);
            assertShows(offscreen.pixels(), "bare");
        }
    }

    /** A view that passes read is not drawn directly into a window, whose format the system chose. */
    @Test
    void whatIsReadIsNotDrawnStraightIntoAWindow() {
        try (Offscreen offscreen = new Offscreen(SIDE, SIDE);
                Multisampling usual = new Multisampling(offscreen.gl, 1, false);
                Multisampling read = new Multisampling(offscreen.gl, 1, true)) {
            RenderTarget window = RenderTarget.window(offscreen.gl, SIDE, SIDE);
            assertSame(window, usual.inPlaceOf(window, window.format()));
            assertNotNull(read.inPlaceOf(window, window.format()).colour());
            assertSame(offscreen.picture, read.inPlaceOf(offscreen.picture, PixelFormat.RGBA8));
        }
    }

    @Test
    void aViewIsReadOnlyAfterItsOpaqueSurfaces() {
        assertRefused(withTrial(Stage.IN_VIEWS), "distance is of stage IN_VIEWS, but stands after");
        assertRefused(List.of(DistancePass.of(Stage.IN_VIEWS)), "distance reads a copy of its view, but is of stage");
    }

    private static void assertRefused(List<RenderFeature> features, String because) {
        try (Offscreen offscreen = new Offscreen(8, 8)) {
            var before = offscreen.gl.live().counts();
            Scene scene = Scene.of(heldCube(), TestAssets.NONE);
            RenderSettings played = RenderSettings.of(Output.PLAIN).with(CharacterPresence.POSSIBLE);
            var e = assertThrows(
                    IllegalStateException.class, () -> LevelRenderer.load(offscreen.gl, scene, played, features));
            assertTrue(e.getMessage().startsWith(because), e.getMessage());
            assertEquals(before, offscreen.gl.live().counts());
        }
    }

    private static Level heldCube() {
        return new TestLevel().ambient(1).cube(null, Vec3.ZERO, 1).level();
    }
}
