package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.gl.BareFrame;
import nephele.engine.render.gl.DrawState.DepthOf;
import nephele.engine.render.gl.DrawState.Stencil;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** A level without portals makes not one call for them; a recorded frame with portals repeats. */
class PortalFreeGlTest {
    private static TestLevel boxes() {
        return new TestLevel()
                .sun(new Vec3(0.3, 1, 0.5), 2)
                .ambient(0.2)
                .sky(new Sky.Gradient(TestLevel.grey(0.1), TestLevel.grey(0.6), TestLevel.grey(0.3)))
                .material("red", new Vec3(0.9, 0.2, 0.1))
                .box("red", new Vec3(0, -1, -2), new Vec3(9, 1, 9))
                .box(null, new Vec3(0, 0, -3), new Vec3(1, 1, 1));
    }

    /** Adds a cube that moves in the light of a sun that casts shadows. */
    private static TestLevel shaded() {
        return boxes().castingSun(new Vec3(0.3, 1, 0.5), 2).cube("red", new Vec3(-0.9, 0.2, -0.5), 0.5);
    }

    /** Returns the settings of players: multisampling, rims. */
    private static RenderSettings settings(Output output) {
        return RenderSettings.of(output, Quality.HIGH.inOneFrame().with("samples", 4));
    }

    private static List<String> words(Level level, List<RenderFeature> features, Output output) {
        try (Offscreen offscreen = new Offscreen(32, 18);
                Renderer renderer = LevelRenderer.load(
                        offscreen.gl, Scene.of(level, TestAssets.NONE), settings(output), features)) {
            View view = offscreen.view(new Vec3(0, 1, 2), new Vec3(0, 0, -3));
            try (BareFrame frame = BareFrame.record(offscreen.gl, () -> renderer.draw(view, offscreen.picture))) {
                return frame.words();
            }
        }
    }

    /** A level without portals makes the same calls as with no portal feature registered. */
    @ParameterizedTest
    @EnumSource
    void aLevelWithoutPortalsMakesTheSameCalls(Output output) {
        List<RenderFeature> without = RenderFeatures.ALL.stream()
                .filter(feature -> !feature.name().startsWith("portal"))
                .toList();
        assertTrue(without.size() <= RenderFeatures.ALL.size() - 2);
        List<String> with = words(shaded().level(), RenderFeatures.ALL, output);
        assertTrue(with.size() > 10);
        assertEquals(words(shaded().level(), without, output), with);
    }

    @Test
    void aLevelWithPortalsMakesMoreCalls() {
        Level portals = boxes().portal("a", "b", new Vec3(0, 0.5, -1), new Vec3(0, 0, 1), 1, 1)
                .portal("b", "a", new Vec3(3, 0.5, -1), new Vec3(0, 0, 1), 1, 1)
                .level();
        assertTrue(words(portals, RenderFeatures.ALL, Output.PLAIN).size()
                > words(boxes().level(), RenderFeatures.ALL, Output.PLAIN).size());
    }

    /**
     * Drawing does not depend on the state that another renderer of the context left: stencil and depth range are set.
     */
    @Test
    void itDoesNotRelyOnWhatOthersLeft() {
        try (Offscreen offscreen = new Offscreen(32, 18);
                Renderer renderer = LevelRenderer.load(
                        offscreen.gl, boxes().level(), TestAssets.NONE, RenderSettings.of(Output.PLAIN))) {
            View view = offscreen.view(new Vec3(0, 1, 2), new Vec3(0, 0, -3));
            renderer.draw(view, offscreen.picture);
            int[] expected = offscreen.pixels();
            offscreen.gl.state().stencil(Stencil.EQUAL, 3);
            offscreen.gl.state().depthOf(DepthOf.FARTHEST);
            renderer.draw(view, offscreen.picture);
            assertArrayEquals(expected, offscreen.pixels());
        }
    }

    /** No picture is kept for openings outside the view, also with a small budget. */
    @Test
    void withNoPortalInViewNoPictureIsKept() {
        Level level = boxes().portal("a", "b", new Vec3(0, 0.5, -1), new Vec3(0, 0, 1), 1, 1)
                .portal("b", "a", new Vec3(3, 0.5, -1), new Vec3(0, 0, 1), 1, 1)
                .level();
        for (int budget = 0; budget < 3; budget++) {
            RenderSettings history = RenderSettings.of(Output.PLAIN)
                    .with(Quality.HIGH.inOneFrame().with("viewBudget", budget));
            RenderSettings mark = history.with(RenderSettings.Deepest.MARK);
            assertEquals(wordsLookingAway(level, mark), wordsLookingAway(level, history), "budget " + budget);
        }
    }

    private static List<String> wordsLookingAway(Level level, RenderSettings settings) {
        try (Offscreen offscreen = new Offscreen(32, 18);
                Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, settings)) {
            View view = offscreen.view(new Vec3(0, 1, 2), new Vec3(0, 0, 9));
            try (BareFrame frame = BareFrame.record(offscreen.gl, () -> renderer.draw(view, offscreen.picture))) {
                return frame.words();
            }
        }
    }

    /** The recorded frame of {@code bench --bare} draws the same picture: portals with rims, a cube and its shadow. */
    @ParameterizedTest
    @EnumSource
    void theBareTwinDrawsPortalsToo(Output output) {
        Level level = shaded().portal("a", "b", new Vec3(0, 0.5, -1), new Vec3(0, 0, 1), 1, 1)
                .portal("b", "a", new Vec3(2, 0.5, 1), new Vec3(0, 0, -1), 1, 1)
                .level();
        try (Offscreen offscreen = new Offscreen(64, 36);
                Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, settings(output))) {
            List<View> views = List.of(
                    offscreen.view(new Vec3(0, 1, 2), new Vec3(0, 0, -3)),
                    offscreen.view(new Vec3(0.4, 0.7, 0), new Vec3(0, 0.4, -3)));
            try (BareTwin twin = new BareTwin(offscreen.gl, renderer, views, offscreen.picture)) {
                for (int i = 0; i < views.size(); i++) {
                    twin.draw(i);
                    int[] bare = offscreen.pixels();
                    renderer.draw(views.get(i), offscreen.picture);
                    assertArrayEquals(offscreen.pixels(), bare);
                    assertTrue(renderer.viewsDrawn() > 0);
                }
            }
        }
    }
}
