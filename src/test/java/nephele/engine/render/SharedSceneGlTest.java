package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Sky;
import nephele.engine.level.SkyboxLayout;
import nephele.engine.level.Solid;
import nephele.engine.level.TestLevel;
import nephele.engine.level.ToneCurve;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.GlKind;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.engine.scene.light.LevelLight;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Renderers that share data, edits and changes of the environment draw correctly. */
class SharedSceneGlTest {
    private static final RenderSettings DIRECT = RenderSettings.of(Output.DIRECT);
    private static final Vec3 MORNING = new Vec3(1, 0.6, 0.3);
    private static final Vec3 EVENING = new Vec3(-1, 0.5, 0.1);

    private static TestLevel room(Vec3 towardsSun, double zenith, double stops) {
        return new TestLevel()
                .castingSun(towardsSun, 2)
                .skyLight()
                .sky(sky(zenith))
                .toneMapping(ToneCurve.CLIP, stops)
                .material("grey", TestLevel.grey(0.5))
                .light(new Light.Point("lamp", new Vec3(0, 2, 0), TestLevel.grey(4), 10, true))
                .box("grey", new Vec3(0, -1, 0), new Vec3(9, 1, 9))
                .box("grey", new Vec3(0, 0, -2), new Vec3(1, 1, 1))
                .cube("grey", new Vec3(1, 0, -1), 0.5);
    }

    private static Sky sky(double zenith) {
        return new Sky.Gradient(new Vec3(0.1, 0.2, zenith), TestLevel.grey(0.5), TestLevel.grey(0.2));
    }

    private static View view(Offscreen offscreen) {
        return offscreen.view(new Vec3(0.4, 1.6, 3), new Vec3(0, -0.5, -1));
    }

    private static int[] drawn(Offscreen offscreen, Renderer renderer, FrameState frameState) {
        renderer.draw(view(offscreen), frameState, offscreen.picture);
        offscreen.gl.requireNoError("frame");
        return offscreen.pixels();
    }

    @Test
    void renderersOfOneSceneHaveItsGeometryPicturesAndMapsOnce() {
        Scene scene = Scene.of(room(MORNING, 0.6, 0).level(), TestAssets.NONE);
        FrameState start = FrameState.atStart(scene.level());
        try (Offscreen offscreen = new Offscreen(64, 48)) {
            var before = offscreen.gl.live().counts();
            Renderer first = LevelRenderer.load(offscreen.gl, scene, DIRECT);
            int[] expected = drawn(offscreen, first, start);
            drawn(offscreen, first, start);
            long steady = first.draws();
            var one = offscreen.gl.live().counts();
            try (Renderer second = LevelRenderer.load(offscreen.gl, scene, DIRECT)) {
                assertArrayEquals(expected, drawn(offscreen, second, start));
                int ofDynamicObjects = 3;
                int textures = offscreen.gl.live().counts().get(GlKind.TEXTURE) - one.get(GlKind.TEXTURE);
                assertTrue(textures < one.get(GlKind.TEXTURE) - before.get(GlKind.TEXTURE), "textures " + textures);
                assertTrue(second.draws() < steady + ofDynamicObjects + 1, "no map of what never moves is drawn again");
                first.close();
                assertArrayEquals(expected, drawn(offscreen, second, start), "what is shared outlives the first");
            }
            assertEquals(before, offscreen.gl.live().counts());
        }
    }

    /**
     * An edited renderer draws as a new one does: with one solid more, one less, another light, another material, no
     * light, and back.
     */
    @Test
    void anEditedRendererDrawsWhatAFreshOneDoes() {
        Level level = room(MORNING, 0.6, 0).level();
        TestLevel more = room(MORNING, 0.6, 0).box("grey", new Vec3(-1.5, 0, 0), new Vec3(0.5, 2, 0.5));
        List<Level> edits = List.of(
                more.level(),
                more.material("red", new Vec3(0.8, 0.1, 0.1))
                        .box("red", new Vec3(2, 0, 0), new Vec3(1, 1, 1))
                        .level(),
                level.with(
                        level.environment(),
                        List.of(new Light.Point("lamp", new Vec3(1, 2, 1), TestLevel.grey(6), 10, true))),
                level.with(level.environment(), List.of()),
                level);
        List<int[]> fresh = edits.stream().map(SharedSceneGlTest::fresh).toList();
        try (Offscreen offscreen = new Offscreen(64, 48)) {
            var before = offscreen.gl.live().counts();
            PlacedLevel placed = PlacedLevel.of(level, TestAssets.NONE);
            Scene scene = Scene.of(placed, LevelLight.of(placed, done -> {}));
            Renderer renderer = LevelRenderer.load(offscreen.gl, scene, DIRECT);
            for (int i = 0; i < fresh.size(); i++) {
                drawn(offscreen, renderer, FrameState.atStart(renderer.scene().level()));
                placed = placed.edited(edits.get(i));
                renderer = LevelRenderer.edited(
                        renderer, renderer.scene().edited(placed, LevelLight.of(placed, done -> {})));
                assertArrayEquals(
                        fresh.get(i), drawn(offscreen, renderer, FrameState.atStart(edits.get(i))), "edit " + i);
            }
            renderer.close();
            assertEquals(before, offscreen.gl.live().counts());
        }
    }

    /**
     * If a solid moves under one of two lights, six layers and the sun's map are drawn again; under none, the sun's
     * alone.
     */
    @Test
    void onlyMapsOfLightsNearAnEditAreDrawnAgain() {
        Level level = new TestLevel()
                .castingSun(MORNING, 2)
                .material("grey", TestLevel.grey(0.5))
                .light(new Light.Point("near", new Vec3(0, 2, 0), TestLevel.grey(4), 4, true))
                .light(new Light.Point("far", new Vec3(60, 2, 0), TestLevel.grey(4), 4, true))
                .box("grey", new Vec3(30, -1, 0), new Vec3(100, 1, 9))
                .box("grey", new Vec3(0, 0, -2), new Vec3(1, 1, 1))
                .box("grey", new Vec3(30, 0, -2), new Vec3(1, 1, 1))
                .level();
        try (Offscreen offscreen = new Offscreen(64, 48)) {
            PlacedLevel placed = PlacedLevel.of(level, TestAssets.NONE);
            Renderer renderer = LevelRenderer.load(offscreen.gl, Scene.of(placed, null), DIRECT);
            FrameState start = FrameState.atStart(level);
            long first = draws(offscreen, renderer, start);
            long steady = draws(offscreen, renderer, start);
            assertTrue(first >= steady + 3, first + " calls, then " + steady);
            long[] more = new long[2];
            for (int moved = 1; moved <= 2; moved++) {
                PlacedLevel other = placed.edited(level.with(level.materials(), movedBy(level.solids(), moved)));
                renderer = LevelRenderer.edited(renderer, renderer.scene().edited(other, null));
                more[moved - 1] = draws(offscreen, renderer, start) - steady;
                assertEquals(steady, draws(offscreen, renderer, start));
                renderer = LevelRenderer.edited(renderer, renderer.scene().edited(placed, null));
                draws(offscreen, renderer, start);
            }
            renderer.close();
            assertEquals(1, more[1], "the sun's map");
            assertTrue(more[0] > 1 && more[0] < first - steady, more[0] + " of " + (first - steady));
        }
    }

    private static List<Solid> movedBy(List<Solid> solids, int place) {
        List<Solid> moved = new ArrayList<>(solids);
        Solid.Box box = (Solid.Box) solids.get(place);
        Vec3 centre =
                new Vec3(box.centre().x() + 0.5, box.centre().y(), box.centre().z());
        moved.set(
                place,
                new Solid.Box(
                        box.id(),
                        box.material(),
                        box.portalable(),
                        box.textureMapping(),
                        centre,
                        box.size(),
                        box.faces()));
        return moved;
    }

    private static int[] fresh(Level level) {
        try (Offscreen offscreen = new Offscreen(64, 48)) {
            return offscreen.pixels(level, TestAssets.NONE, view(offscreen), DIRECT);
        }
    }

    @Test
    void anEditThatCannotBeDrawnLeavesTheRendererAsItIs() {
        Level level = room(MORNING, 0.6, 0).level();
        try (Offscreen offscreen = new Offscreen(64, 48);
                Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, DIRECT)) {
            int[] expected = drawn(offscreen, renderer, FrameState.atStart(level));
            var loaded = offscreen.gl.live().counts();
            Level missing = level.with(
                    new Environment(
                            null,
                            new Sky.Skybox(SkyboxLayout.CROSS, List.of("sky/none.png")),
                            null,
                            Exposure.NEUTRAL,
                            ToneCurve.CLIP,
                            null,
                            List.of()),
                    List.of());
            Scene scene = Scene.of(missing.with(List.of(), List.of(), List.of()), TestAssets.NONE);
            assertThrows(AssetException.class, () -> LevelRenderer.edited(renderer, scene));
            assertEquals(loaded, offscreen.gl.live().counts());
            assertArrayEquals(expected, drawn(offscreen, renderer, FrameState.atStart(level)));
        }
    }

    /** A change of one value of the frame state. */
    enum Change {
        SUN(EVENING, 0.6, 0),
        SKY(MORNING, 0.1, 0),
        EXPOSURE(MORNING, 0.6, 1.5),
        ALL(EVENING, 0.2, -1);

        private final Vec3 towardsSun;
        private final double zenith;
        private final double stops;

        Change(Vec3 towardsSun, double zenith, double stops) {
            this.towardsSun = towardsSun;
            this.zenith = zenith;
            this.stops = stops;
        }

        Level level() {
            return room(towardsSun, zenith, stops).level();
        }
    }

    @ParameterizedTest
    @EnumSource
    void aFrameStatesLightLooksAsALevelsOwn(Change change) {
        Level level = room(MORNING, 0.6, 0).level();
        Level other = change.level();
        for (Output output : List.of(Output.DIRECT, Output.HDR)) {
            RenderSettings settings = RenderSettings.of(output);
            try (Offscreen offscreen = new Offscreen(64, 48);
                    Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, settings)) {
                FrameState frameState = FrameState.atStart(level);
                int[] before = drawn(offscreen, renderer, frameState);
                frameState.environment(other.environment());
                int[] after = drawn(offscreen, renderer, frameState);
                assertTrue(!Arrays.equals(before, after));
                assertArrayEquals(offscreen.pixels(other, TestAssets.NONE, view(offscreen), settings), after);
                frameState.environment(level.environment());
                assertArrayEquals(before, drawn(offscreen, renderer, frameState), "and back");
            }
        }
    }

    /** A change of the sun draws its maps again, once; an equal frame draws none. */
    @Test
    void mapsAreDrawnAgainOnlyWhenTheSunMoves() {
        Level level = room(MORNING, 0.6, 0).level();
        try (Offscreen offscreen = new Offscreen(64, 48);
                Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, DIRECT)) {
            FrameState frameState = FrameState.atStart(level);
            long first = draws(offscreen, renderer, frameState);
            long steady = draws(offscreen, renderer, frameState);
            assertTrue(first > steady, first + " calls, then " + steady);
            frameState.environment(Change.EXPOSURE.level().environment());
            assertEquals(steady, draws(offscreen, renderer, frameState), "the sun stands where it stood");
            frameState.environment(Change.SUN.level().environment());
            assertEquals(steady + 2, draws(offscreen, renderer, frameState), "the map of what stays and of what moves");
            assertEquals(steady, draws(offscreen, renderer, frameState));
        }
    }

    private static long draws(Offscreen offscreen, Renderer renderer, FrameState frameState) {
        drawn(offscreen, renderer, frameState);
        return renderer.draws();
    }
}
