package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.function.Function;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement.TransformStep;
import nephele.engine.level.RecordCopy;
import nephele.engine.level.Sky;
import nephele.engine.level.Solid;
import nephele.engine.level.Terrain;
import nephele.engine.level.TestLevel;
import nephele.engine.level.TestTerrain;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.appearance.FaceTexture;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.DirectLight;
import nephele.engine.render.frame.Quality.LightDirections;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Projection;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.engine.scene.dynamic.CharacterPresence;
import nephele.engine.scene.light.PackedLight;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.engine.scene.light.bake.FormulaLight;
import nephele.engine.scene.light.bake.IndirectLight.Course;
import nephele.engine.scene.light.bake.IndirectLight.SkyLight;
import nephele.engine.scene.light.bake.SkyVisibility;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** Baked light is drawn as its samples say: on solids, models and terrains, and after edits. */
class BakedLightGlTest {
    private static final int SIZE = 24;
    private static final double ALBEDO = 0.6;
    private static final Vec3 OUT = new Vec3(0, 0, 1);

    /** Half a step of the stored radiance below 1, and the rounding of half floats. */
    private static final double ROUNDING = 1e-3;

    private static final Function<Vec3, Vec3> LINEAR =
            p -> new Vec3(0.7 + 0.1 * p.x(), 0.6 + 0.08 * p.y(), 0.75 + 0.05 * p.x() - 0.05 * p.y());
    private static final Function<Vec3, Vec3> EVEN = p -> TestLevel.grey(0.5);

    /** Returns a level with a wall whose face is at z = 0. */
    private static TestLevel wall() {
        return wall(new Material("wall", TestLevel.grey(ALBEDO), null, null, null, null, Vec3.ZERO, 1));
    }

    private static TestLevel wall(Material material) {
        return new TestLevel().material(material).box("wall", new Vec3(0, 0, -0.5), new Vec3(5, 5, 1));
    }

    private static BakedLight light(Level level, AssetSource assets, SkyLight sky, Function<Vec3, Vec3> radiance) {
        return new FormulaLight(PlacedLevel.of(level, assets).statics())
                .layer("", Course.INDIRECT, radiance, OUT.scaled(0.6))
                .baked(sky);
    }

    private static View view(Offscreen offscreen) {
        return offscreen.view(new Vec3(0, 0, 2), Vec3.ZERO);
    }

    private static float[] picture(Offscreen offscreen, Level level, BakedLight light, Quality quality) {
        return pictures(offscreen, PlacedLevel.of(level, TestAssets.NONE), light, quality, List.of(Map.of()))
                .get(0);
    }

    private static List<float[]> pictures(
            Offscreen offscreen,
            PlacedLevel placed,
            BakedLight light,
            Quality quality,
            List<Map<String, Double>> gains) {
        Scene scene = Scene.of(placed, light);
        List<float[]> drawn = new ArrayList<>();
        try (Renderer renderer = LevelRenderer.load(offscreen.gl, scene, RenderSettings.of(Output.HDR, quality))) {
            FrameState state = FrameState.atStart(placed.level());
            for (Map<String, Double> some : gains) {
                state.layerGains(some);
                renderer.draw(view(offscreen), state, offscreen.picture);
                offscreen.gl.requireNoError("baked light");
                drawn.add(renderer.readRadiance());
            }
        }
        return drawn;
    }

    /** Calls for each pixel with the point of the plane z that it shows. */
    private static void forEachPixel(Offscreen offscreen, double z, BiConsumer<Integer, Vec3> pixel) {
        for (int i = 0; i < SIZE * SIZE; i++) {
            Vec3 ray = offscreen.ray(view(offscreen), i);
            pixel.accept(i, new Vec3(0, 0, 2).addScaled((z - 2) / ray.z(), ray));
        }
    }

    private static void assertRadiance(Vec3 expected, float[] picture, int pixel, double tolerance) {
        assertEquals(expected.x(), picture[3 * pixel], tolerance, "red of pixel " + pixel);
        assertEquals(expected.y(), picture[3 * pixel + 1], tolerance, "green of pixel " + pixel);
        assertEquals(expected.z(), picture[3 * pixel + 2], tolerance, "blue of pixel " + pixel);
    }

    @Test
    void aMattWallShowsItsAlbedoTimesTheLight() {
        Level level = wall().level();
        BakedLight light = light(level, TestAssets.NONE, SkyLight.LIVE, LINEAR);
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            float[] picture = picture(offscreen, level, light, Quality.HIGH.inOneFrame());
            forEachPixel(
                    offscreen,
                    0,
                    (i, place) -> assertRadiance(LINEAR.apply(place).scaled(ALBEDO), picture, i, ROUNDING));
        }
    }

    /** What the sky gives is either in the bake or drawn beside it; a constant ambient light is always drawn beside it. */
    @Test
    void theSkyIsDrawnOnlyIfItIsNotBaked() {
        Sky even = new Sky.Constant(TestLevel.grey(0.25));
        Level skylit = wall().skyLight().sky(even).level();
        Level constant = wall().ambient(0.25).level();
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            BakedLight live = light(skylit, TestAssets.NONE, SkyLight.LIVE, EVEN);
            BakedLight baked = light(skylit, TestAssets.NONE, SkyLight.BAKED, EVEN);
            Vec3 both = TestLevel.grey(ALBEDO * 0.75);
            assertRadiance(both, picture(offscreen, skylit, live, Quality.HIGH.inOneFrame()), 300, ROUNDING);
            assertRadiance(
                    TestLevel.grey(ALBEDO * 0.5),
                    picture(offscreen, skylit, baked, Quality.HIGH.inOneFrame()),
                    300,
                    ROUNDING);
            assertRadiance(
                    both,
                    picture(
                            offscreen,
                            constant,
                            light(constant, TestAssets.NONE, SkyLight.BAKED, EVEN),
                            Quality.HIGH.inOneFrame()),
                    300,
                    ROUNDING);
        }
    }

    /** A hemisphere of even light has half of its luminance as mean direction, and looks the same in each mirrored direction. */
    @Test
    void metalMirrorsEvenLightFromEverywhere() {
        Level level = wall(new Material("wall", TestLevel.grey(ALBEDO), null, 0.5, 1.0, null, Vec3.ZERO, 1))
                .level();
        StaticShapes statics = PlacedLevel.of(level, TestAssets.NONE).statics();
        Quality off = Quality.HIGH.inOneFrame().with("lightDirections", LightDirections.OFF);
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            for (double length : new double[] {0.5, 0.9}) {
                BakedLight light = new FormulaLight(statics)
                        .layer("", Course.INDIRECT, EVEN, OUT.scaled(length))
                        .baked(SkyLight.BAKED);
                float[] plain = picture(offscreen, level, light, off);
                float[] directed = picture(offscreen, level, light, Quality.HIGH.inOneFrame());
                double corner = directed[0] / plain[0];
                assertEquals(length == 0.5 ? 1 : 0.7, corner, length == 0.5 ? 0.01 : 0.2, "length " + length);
            }
        }
    }

    /** Flat walls are the same with and without directions; a normal map is lit by the ratio of its twin. */
    @Test
    void directionsTellForNormalMapsAlone() {
        TestAssets assets = new TestAssets().picture("n.png", 2, 2, (x, y) -> 0xd080e0);
        Material relief = new Material("relief", TestLevel.grey(ALBEDO), null, null, null, "n.png", Vec3.ZERO, 1);
        Level level = wall(relief)
                .material("wall", TestLevel.grey(ALBEDO))
                .box("relief", new Vec3(0, -2.5, 0.1), new Vec3(5, 5, 0.2))
                .level();
        PlacedLevel placed = PlacedLevel.of(level, assets);
        Vec3 d = new Vec3(0.5, 0.1, 0.6);
        BakedLight light = new FormulaLight(placed.statics())
                .layer("", Course.INDIRECT, EVEN, d)
                .baked(SkyLight.BAKED);
        Quality off = Quality.HIGH.inOneFrame().with("lightDirections", LightDirections.OFF);
        Vector3d tilted = FaceTexture.mappedNormal(
                new Vector3d(0xd0 / 255.0, 0x80 / 255.0, 0xe0 / 255.0),
                OUT.toVector(),
                new Vector3d(1, 0, 0),
                new Vector3d(0, 1, 0));
        double ratio = PackedLight.relativeIrradiance(d, Vec3.of(tilted)) / PackedLight.relativeIrradiance(d, OUT);
        assertTrue(ratio > 1.2, "ratio " + ratio);
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            float[] directed = pictures(offscreen, placed, light, Quality.HIGH.inOneFrame(), List.of(Map.of()))
                    .get(0);
            float[] plain =
                    pictures(offscreen, placed, light, off, List.of(Map.of())).get(0);
            for (int i = 0; i < SIZE * SIZE; i++) {
                boolean isRelief = i < SIZE * SIZE / 2;
                double factor = isRelief ? ratio : 1;
                assertRadiance(TestLevel.grey(ALBEDO * 0.5), plain, i, ROUNDING);
                assertRadiance(TestLevel.grey(ALBEDO * 0.5 * factor), directed, i, isRelief ? 0.005 : ROUNDING);
            }
        }
    }

    /** The picture of all layers is the sum of those of each; gains change between two frames. */
    @Test
    void layersAddUp() {
        Level level = wall().model("torus_1.5_0.45_24_12.3d", "wall").level();
        PlacedLevel placed = PlacedLevel.of(level, TestAssets.NONE);
        BakedLight light = new FormulaLight(placed.statics())
                .layer("", Course.INDIRECT, LINEAR.andThen(v -> v.scaled(0.3)), OUT.scaled(0.5))
                .layer("lamps", Course.INDIRECT, p -> new Vec3(0.2, 0.4, 0.1), OUT.scaled(0.2))
                .layer("lamps", Course.DIRECT, p -> TestLevel.grey(9), OUT)
                .baked(SkyLight.BAKED);
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            List<float[]> drawn = pictures(
                    offscreen,
                    placed,
                    light,
                    Quality.HIGH.inOneFrame(),
                    List.of(Map.of(), Map.of("lamps", 0.0), Map.of("lamps", 0.5), Map.of()));
            for (int i = 0; i < 3 * SIZE * SIZE; i++) {
                float without = drawn.get(1)[i];
                assertTrue(drawn.get(0)[i] > without + 0.03, "value " + i);
                assertEquals((drawn.get(0)[i] + without) / 2, drawn.get(2)[i], ROUNDING, "value " + i);
            }
            assertArrayEquals(drawn.get(0), drawn.get(3));
        }
    }

    /** A lamp of a layer is dimmed with it, with a bake or without one, as if its intensity were written so. */
    @Test
    void liveLampsAreDimmedAsTheirLayer() {
        Light lamp = new Light.Point("lamp", new Vec3(0, 0, 3), new Vec3(5, 3, 4), 10, false, "lamps");
        Light other = new Light.Point("other", new Vec3(0, 1, 2), new Vec3(1, 1, 2), 10, false);
        PlacedLevel placed = PlacedLevel.of(wall().light(lamp).light(other).level(), TestAssets.NONE);
        PlacedLevel dimmed =
                PlacedLevel.of(wall().light(lamp.dimmed(0.25)).light(other).level(), TestAssets.NONE);
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            List<float[]> gained = pictures(
                    offscreen,
                    placed,
                    null,
                    Quality.HIGH.inOneFrame(),
                    List.of(Map.of("lamps", 0.25), Map.of("lamps", 1.0)));
            List<float[]> written = List.of(
                    pictures(offscreen, dimmed, null, Quality.HIGH.inOneFrame(), List.of(Map.of()))
                            .get(0),
                    pictures(offscreen, placed, null, Quality.HIGH.inOneFrame(), List.of(Map.of()))
                            .get(0));
            for (int i = 0; i < 2; i++) {
                assertArrayEquals(written.get(i), gained.get(i));
            }
            assertFalse(Arrays.equals(gained.get(0), gained.get(1)));
        }
    }

    @Test
    void aModelTakesTheLightOfItsVertices() {
        Level level = wall().model(
                        "box_1_1.3d",
                        "wall",
                        new TransformStep.Translate(new Vec3(0, 0, 0.25)),
                        new TransformStep.Scale(new Vec3(5, 5, 0.5)))
                .level();
        BakedLight light = light(level, TestAssets.NONE, SkyLight.BAKED, LINEAR);
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            float[] picture = picture(offscreen, level, light, Quality.HIGH.inOneFrame());
            forEachPixel(
                    offscreen,
                    0.5,
                    (i, place) -> assertRadiance(LINEAR.apply(place).scaled(ALBEDO), picture, i, ROUNDING));
        }
    }

    @Test
    void aTerrainTakesTheLightOfItsGrid() {
        TestAssets assets = TestTerrain.map(33, (column, row) -> 0);
        Level level = new TestLevel()
                .material("ground", TestLevel.grey(ALBEDO))
                .level()
                .withTerrains(List.of(TestTerrain.said("t", "map.r16", Terrain.Layer.everywhere("ground"))));
        Function<Vec3, Vec3> light = p -> new Vec3(0.7 + 0.005 * p.x(), 0.6 + 0.004 * p.z(), 0.6);
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            View view = View.lookAt(
                    new Vec3(3, 8, 4),
                    new Vec3(3, 0, 4),
                    new Vec3(0, 0, -1),
                    new Projection(Math.PI / 2, 1, 0.05, 1000));
            Scene scene = Scene.of(PlacedLevel.of(level, assets), light(level, assets, SkyLight.BAKED, light));
            try (Renderer renderer =
                    LevelRenderer.load(offscreen.gl, scene, RenderSettings.of(Output.HDR, Quality.HIGH.inOneFrame()))) {
                renderer.draw(view, offscreen.picture);
                float[] picture = renderer.readRadiance();
                for (int i = 0; i < SIZE * SIZE; i++) {
                    Vec3 ray = offscreen.ray(view, i);
                    Vec3 place = new Vec3(3, 8, 4).addScaled(-8 / ray.y(), ray);
                    assertRadiance(light.apply(place).scaled(ALBEDO), picture, i, ROUNDING);
                }
            }
        }
    }

    /** A wall that moves away takes its light along, and so does everything that stays; another bake replaces it. */
    @Test
    void anEditedLevelKeepsItsLightUntilTheNextBake() {
        Level level = wall().level();
        Solid farther = RecordCopy.with((Solid.Box) level.solids().get(0), "centre", new Vec3(0.1, 0, -0.75));
        Level moved = level.with(level.materials(), List.of(farther));
        PlacedLevel placed = PlacedLevel.of(level, TestAssets.NONE);
        BakedLight light = light(level, TestAssets.NONE, SkyLight.BAKED, LINEAR);
        BakedLight other = new BakedLight(
                light.visibility(),
                light(level, TestAssets.NONE, SkyLight.BAKED, EVEN).indirect());
        RenderSettings settings = RenderSettings.of(Output.HDR, Quality.HIGH.inOneFrame());
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            Renderer renderer = LevelRenderer.load(offscreen.gl, Scene.of(placed, light), settings);
            PlacedLevel edited = placed.edited(moved);
            renderer = LevelRenderer.edited(renderer, renderer.scene().edited(edited, null));
            renderer.draw(view(offscreen), offscreen.picture);
            float[] old = renderer.readRadiance();
            forEachPixel(
                    offscreen,
                    -0.25,
                    (i, place) -> assertRadiance(
                            LINEAR.apply(place.minus(new Vec3(0.1, 0, 0))).scaled(ALBEDO), old, i, ROUNDING));
            Object solids = renderer.scene().solids();
            renderer = LevelRenderer.edited(renderer, renderer.scene().edited(edited, other));
            assertTrue(solids == renderer.scene().solids(), "nothing is meshed again");
            renderer.draw(view(offscreen), offscreen.picture);
            assertRadiance(TestLevel.grey(ALBEDO * 0.5), renderer.readRadiance(), 300, ROUNDING);
            renderer.close();
        }
    }

    /** Without a sky a new solid looks like the nearest face that looks the same way, not black. */
    @Test
    void aNewSolidInARoomWithoutSkyIsLitLikeItsNeighbour() {
        Level level = wall().box("wall", new Vec3(0, -9, 0), new Vec3(5, 1, 5)).level();
        List<Solid> more = new ArrayList<>(level.solids());
        more.add(new Solid.Box(
                "new", "wall", false, TextureMapping.WORLD, new Vec3(1, 0, 0.2), new Vec3(1, 1, 0.4), Map.of()));
        PlacedLevel placed = PlacedLevel.of(level, TestAssets.NONE);
        BakedLight light = light(level, TestAssets.NONE, SkyLight.BAKED, LINEAR);
        BakedLight dark = new BakedLight(SkyVisibility.even(light.statics(), false), light.indirect());
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            Renderer renderer = LevelRenderer.load(
                    offscreen.gl, Scene.of(placed, dark), RenderSettings.of(Output.HDR, Quality.HIGH.inOneFrame()));
            PlacedLevel edited = placed.edited(level.with(level.materials(), more));
            renderer = LevelRenderer.edited(renderer, renderer.scene().edited(edited, null));
            renderer.draw(view(offscreen), offscreen.picture);
            int pixel = SIZE * SIZE / 2 + 3 * SIZE / 4;
            Vec3 ray = offscreen.ray(view(offscreen), pixel);
            Vec3 place = new Vec3(0, 0, 2).addScaled(-1.6 / ray.z(), ray);
            assertRadiance(LINEAR.apply(place).scaled(ALBEDO), renderer.readRadiance(), pixel, 0.01);
            renderer.close();
        }
    }

    /** Lightning needs the sky's visibility even where the sky's light is baked; between flashes it changes nothing. */
    @Test
    void lightningBesideABakedSkyChangesNothingBetweenFlashes() {
        Sky even = new Sky.Constant(TestLevel.grey(0.25));
        Environment.Lightning rare = new Environment.Lightning(
                1e-3, 0, new Vec3(0, 900, -9000), new Vec3(900, 300, 900), 0, 0.6, TestLevel.grey(1e6));
        TestLevel skylit = wall().skyLight().sky(even);
        Level calm = skylit.level();
        Level stormy = skylit.lightning(rare).level();
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            float[] without = picture(
                    offscreen, calm, light(calm, TestAssets.NONE, SkyLight.BAKED, LINEAR), Quality.HIGH.inOneFrame());
            float[] with = picture(
                    offscreen,
                    stormy,
                    light(stormy, TestAssets.NONE, SkyLight.BAKED, LINEAR),
                    Quality.HIGH.inOneFrame());
            assertArrayEquals(without, with, 1e-6f);
        }
    }

    /** Light straight from sun and lamps is drawn once: live, or from the bake without any shadow map. */
    @Test
    void directLightIsLiveOrBaked() {
        Level level = wall().castingSun(new Vec3(0, 0.6, 0.8), 2)
                .light(new Light.Point("lamp", new Vec3(0, 0, 3), TestLevel.grey(5), 10, true))
                .box("wall", new Vec3(4, 0, 1), new Vec3(1, 1, 1))
                .level();
        PlacedLevel placed = PlacedLevel.of(level, TestAssets.NONE);
        BakedLight light = new FormulaLight(placed.statics())
                .layer("", Course.INDIRECT, p -> TestLevel.grey(0.125), OUT)
                .layer("", Course.DIRECT, EVEN, OUT)
                .baked(SkyLight.BAKED);
        Quality baked = Quality.HIGH.inOneFrame().with("directLight", DirectLight.BAKED);
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            assertRadiance(TestLevel.grey(ALBEDO * 0.625), picture(offscreen, level, light, baked), 300, ROUNDING);
            float[] live = picture(offscreen, level, null, Quality.HIGH.inOneFrame());
            Vec3 sum = new Vec3(live[900], live[901], live[902]).plus(TestLevel.grey(ALBEDO * 0.125));
            assertRadiance(sum, picture(offscreen, level, light, Quality.HIGH.inOneFrame()), 300, ROUNDING);
        }
        assertTrue(plan(placed, light, Quality.HIGH.inOneFrame()).containsAll(List.of("shadow.sun", "baked-light")));
        assertEquals(List.of("baked-light", "solid", "tonemap"), plan(placed, light, baked));
        assertFalse(plan(placed, null, baked).contains("baked-light"));
        assertEquals(plan(placed, null, Quality.HIGH.inOneFrame()), plan(placed, null, baked));
    }

    /** A mirror-like floor under a baked lamp shows what is around it, not the lamp's light as if it came from everywhere. */
    @Test
    void glossMirrorsNoBakedSun() {
        Level level = wall(new Material("wall", TestLevel.grey(1), null, 0.1, 1.0, null, Vec3.ZERO, 1))
                .model(
                        "box_1_1.3d",
                        "wall",
                        new TransformStep.Translate(new Vec3(0, -1.5, 0.25)),
                        new TransformStep.Scale(new Vec3(5, 1, 0.5)))
                .castingSun(new Vec3(0, 0.6, 0.8), 2)
                .level();
        PlacedLevel placed = PlacedLevel.of(level, TestAssets.NONE);
        BakedLight light = new FormulaLight(placed.statics())
                .layer("", Course.INDIRECT, p -> TestLevel.grey(0.25), Vec3.ZERO)
                .layer("", Course.DIRECT, p -> TestLevel.grey(8), Vec3.ZERO)
                .baked(SkyLight.BAKED);
        Quality baked = Quality.HIGH.inOneFrame().with("directLight", DirectLight.BAKED);
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            for (LightDirections directions : LightDirections.values()) {
                float[] picture = picture(offscreen, level, light, baked.with("lightDirections", directions));
                for (int i = 0; i < 3 * SIZE * SIZE; i++) {
                    assertEquals(0.25, picture[i], 0.01, directions + ", value " + i);
                }
            }
        }
    }

    private static List<String> plan(PlacedLevel placed, BakedLight light, Quality quality) {
        var request = FrameRequest.of(
                placed.level(),
                placed.statics(),
                light == null ? null : light.indirect(),
                Output.HDR,
                quality,
                CharacterPresence.NEVER);
        return FramePlan.of(request).steps().stream()
                .filter(step -> !step.required().isEmpty())
                .map(step -> step.feature().name())
                .toList();
    }
}
