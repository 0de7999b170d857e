package nephele.engine.render.pass.terrain;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import nephele.engine.asset.LayerMap;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.RecordCopy;
import nephele.engine.level.Terrain;
import nephele.engine.level.TestLevel;
import nephele.engine.level.TestTerrain;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.TracedLevel;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.LayerMixing;
import nephele.engine.scene.View;
import nephele.lab.bake.TracedPictures;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A layer map is drawn as it is traced; where it says nothing, nothing changes, and full paint is one layer alone. */
class PaintedLayersGlTest {
    private static final int SIZE = 96;
    private static final Terrain.Layer LOW = new Terrain.Layer("low", -1e7, 5, 2, 0, 25);
    private static final Terrain.Layer HIGH = new Terrain.Layer("high", 5, 1e7, 2, 0, 25);
    private static final Terrain.Layer STEEP = new Terrain.Layer("steep", -1e7, 1e7, 0, 25, 90);

    private static Level level(String layerMap, boolean pictured, Terrain.Layer... layers) {
        TestLevel level = new TestLevel()
                .material(new Material("low", new Vec3(0.2, 0.5, 0.1), null, null, null, null, Vec3.ZERO, 1))
                .material(material("high", new Vec3(0.7, 0.7, 0.8), pictured ? "a.png" : null, 0.9, 0.1))
                .material(material("steep", new Vec3(0.5, 0.3, 0.2), pictured ? "b.png" : null, 0.6, 0.2))
                .ambient(0.2)
                .sun(new Vec3(0.4, 0.7, 0.5), 3);
        Terrain said = TestTerrain.said("t", "map.r16", layers).withLayerMap(layerMap);
        return level.level().withTerrains(List.of(RecordCopy.with(said, "centre", new Vec3(7, 3, -5))));
    }

    private static Material material(String id, Vec3 colour, String picture, double roughness, double metallic) {
        return new Material(id, colour, picture, roughness, metallic, null, new Vec3(0, 0, 0.1 * metallic), 20);
    }

    private static TestAssets assets(LayerMap map) {
        return TestTerrain.map(70, TestTerrain::wavy)
                .picture("a.png", 32, 32, (x, y) -> 0x010101 * wave(x))
                .picture("b.png", 32, 32, (x, y) -> 0x010001 * wave(y) + 0x8000)
                .file("layers.png", map.png());
    }

    private static int wave(int at) {
        return (int) (150 + 80 * Math.sin(2 * Math.PI * at / 32));
    }

    /** Stripes of all layers along x, with weights that rise along z; nothing is painted in the left half. */
    private static LayerMap stripes(int columns, int rows) {
        LayerMap map = LayerMap.blank(columns, rows);
        for (int i = 0; i < columns * rows; i++) {
            boolean isPainted = i % columns >= columns / 2;
            map.texels()[2 * i] = (byte) (i % columns % 3);
            map.texels()[2 * i + 1] = (byte) (isPainted ? 255 * (i / columns) / (rows - 1) : 0);
        }
        return map;
    }

    private static LayerMap full(int layer) {
        LayerMap map = LayerMap.blank(3, 2);
        for (int i = 0; i < 6; i++) {
            map.texels()[2 * i] = (byte) layer;
            map.texels()[2 * i + 1] = (byte) 255;
        }
        return map;
    }

    private static View view(Offscreen offscreen) {
        return offscreen.view(new Vec3(9, 22, 13), new Vec3(7, 5, -5));
    }

    private static int[] drawn(Level level, TestAssets assets, LayerMixing mixing) {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            Quality quality = Quality.HIGH.with("terrainLayers", mixing);
            int[] pixels = offscreen.pixels(level, assets, view(offscreen), RenderSettings.of(Output.DIRECT, quality));
            offscreen.gl.requireNoError("painted layers");
            return pixels;
        }
    }

    private static int differing(Level level, TestAssets assets, Quality quality, double share) {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            View view = view(offscreen);
            float[] drawn =
                    offscreen.radiance(level, assets, List.of(view), quality).get(0);
            TracedLevel twin = TracedLevel.of(PlacedLevel.of(level, assets), ColourDecoding.SRGB);
            float[] traced = ReferencePicture.trace(
                    twin, TracedPictures.pinhole(view), new TraceSettings(SIZE, SIZE, 1, 1, 2), done -> {});
            int differing = 0;
            for (int i = 0; i < drawn.length; i++) {
                differing += Math.abs(drawn[i] - traced[i]) > share * Math.max(traced[i], 0.05) ? 1 : 0;
            }
            return differing;
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void paintIsDrawnAsItIsTraced(boolean pictured) {
        TestAssets assets = assets(stripes(13, 9));
        int differing = differing(level("layers.png", pictured, LOW, HIGH, STEEP), assets, Quality.HIGH, 0.03);
        assertTrue(differing < 0.02 * 3 * SIZE * SIZE, differing + " values differ");
        Level bare = level(null, pictured, LOW, HIGH, STEEP);
        int[] painted = drawn(level("layers.png", pictured, LOW, HIGH, STEEP), assets, LayerMixing.MIXED);
        assertFalse(Arrays.equals(drawn(bare, assets, LayerMixing.MIXED), painted), "paint is seen");
    }

    @Test
    void paintIsSeenInAMixtureThatIsMadeOnce() {
        Level level = level("layers.png", false, LOW, HIGH, STEEP);
        Quality quality = Quality.HIGH.with("terrainLayers", LayerMixing.BAKED);
        int differing = differing(level, assets(stripes(13, 9)), quality, 0.1);
        assertTrue(differing < 0.08 * 3 * SIZE * SIZE, differing + " values differ");
    }

    @ParameterizedTest
    @EnumSource(LayerMixing.class)
    void nothingPaintedIsNoMap(LayerMixing mixing) {
        LayerMap map = LayerMap.blank(5, 4);
        for (int i = 0; i < map.texels().length; i += 2) {
            map.texels()[i] = (byte) (i % 200);
        }
        TestAssets assets = assets(map);
        int[] bare = drawn(level(null, true, LOW, HIGH, STEEP), assets, mixing);
        assertArrayEquals(bare, drawn(level("layers.png", true, LOW, HIGH, STEEP), assets, mixing));
    }

    /** Colours may round to the other of two neighbouring codes, since two shaders add them in different orders. */
    @ParameterizedTest
    @EnumSource(LayerMixing.class)
    void fullPaintIsOneLayerAlone(LayerMixing mixing) {
        Terrain.Layer[] all = {LOW, HIGH, STEEP};
        for (int layer = 1; layer < 3; layer++) {
            TestAssets assets = assets(full(layer));
            Terrain.Layer everywhere = Terrain.Layer.everywhere(all[layer].material());
            int[] alone = drawn(level(null, true, everywhere), assets, mixing);
            int[] painted = drawn(level("layers.png", true, all), assets, mixing);
            for (int i = 0; i < alone.length; i++) {
                for (int shift = 0; shift < 24; shift += 8) {
                    assertEquals(alone[i] >> shift & 255, painted[i] >> shift & 255, 1, "pixel " + i);
                }
            }
        }
    }

    /** Where the map is blank, the picture has the bits of a level without one. */
    @Test
    void paintStaysWhereItIs() {
        TestAssets assets = assets(stripes(65, 9));
        int[] bare = drawn(level(null, false, LOW, HIGH, STEEP), assets, LayerMixing.MIXED);
        int[] painted = drawn(level("layers.png", false, LOW, HIGH, STEEP), assets, LayerMixing.MIXED);
        int left = 0;
        int right = 0;
        for (int i = 0; i < bare.length; i++) {
            boolean isLeft = i % SIZE < SIZE / 3;
            left += isLeft && bare[i] != painted[i] ? 1 : 0;
            right += !isLeft && bare[i] != painted[i] ? 1 : 0;
        }
        assertEquals(0, left);
        assertTrue(right > SIZE * SIZE / 6, right + " pixels");
    }
}
