package nephele.engine.render.pass.terrain;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntBinaryOperator;
import java.util.stream.Stream;
import nephele.engine.asset.LayerMap;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.Terrain;
import nephele.engine.level.Terrain.Layer;
import nephele.engine.level.TestLevel;
import nephele.engine.level.TestTerrain;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.engine.scene.light.bake.BakedLight;
import org.junit.jupiter.api.Test;

/** After an edit of heights or paint the picture is the one of a level that was opened so: shadows, the sky's light, triangles. */
class TerrainEditGlTest {
    private static final int SIDE = 129;
    private static final RenderSettings SETTINGS = RenderSettings.of(Output.DIRECT);

    private static int bump(int column, int row, int atColumn, int atRow, int most) {
        double d = Math.hypot(column - atColumn, row - atRow) / 9;
        return (int) (d < 1 ? most * (1 - d * d) * (1 - d * d) : 0);
    }

    private static byte[] map(IntBinaryOperator value) {
        return TestTerrain.map(SIDE, value).bytes("map.r16");
    }

    private static final TestAssets MAPS = new TestAssets()
            .file("a.r16", map(TestTerrain::wavy))
            .file("b.r16", map((column, row) -> TestTerrain.wavy(column, row) + bump(column, row, 70, 60, 9000)))
            .file("c.r16", map((column, row) -> TestTerrain.wavy(column, row) - bump(column, row, 128, 40, 9000)))
            .file("d.r16", map((column, row) -> 65535 - TestTerrain.wavy(column, row)))
            .file("first.png", painted(4))
            .file("second.png", painted(7));

    /** Returns a layer map with layer 1 in its middle. */
    private static byte[] painted(int side) {
        LayerMap map = LayerMap.blank(side, side);
        int middle = 2 * (side * (side / 2) + side / 2);
        map.texels()[middle] = 1;
        map.texels()[middle + 1] = (byte) 200;
        return map.png();
    }

    /** Its records are the same in all versions, so that an edit changes the terrain alone. */
    private static final Level BASE = new TestLevel()
            .castingSun(new Vec3(0.8, 0.35, 0.3), 3)
            .sky(new Sky.Constant(new Vec3(0.4, 0.6, 0.9)))
            .material("wall", new Vec3(0.7, 0.7, 0.7))
            .material("red", new Vec3(0.8, 0.1, 0.1))
            .box("wall", new Vec3(4, 5, 0), new Vec3(1, 12, 8))
            .level();

    private static Level level(String map) {
        return BASE.withTerrains(List.of(TestTerrain.said("t", map)));
    }

    private static View view(Offscreen offscreen) {
        return offscreen.view(new Vec3(-10, 25, 38), new Vec3(0, 4, 0));
    }

    @Test
    void editedHeightsLookAsIfOpenedSo() {
        assertEditsAreSeen(Stream.of("a.r16", "b.r16", "c.r16", "a.r16", "d.r16")
                .map(TerrainEditGlTest::level)
                .toList());
    }

    /** The first map comes and goes, the second has another size. */
    @Test
    void editedPaintLooksAsIfOpenedSo() {
        Terrain said = TestTerrain.said("t", "a.r16", Layer.everywhere("wall"), Layer.everywhere("red"));
        assertEditsAreSeen(Stream.of(null, "first.png", "second.png", null)
                .map(said::withLayerMap)
                .map(terrain -> BASE.withTerrains(List.of(terrain)))
                .toList());
    }

    private static void assertEditsAreSeen(List<Level> levels) {
        List<int[]> edited = edited(levels);
        for (int i = 0; i < levels.size(); i++) {
            String what = "version " + i;
            assertArrayEquals(opened(levels.get(i)), edited.get(i), what);
            assertFalse(i > 0 && Arrays.equals(edited.get(i - 1), edited.get(i)), what + " is seen");
        }
    }

    private static List<int[]> edited(List<Level> levels) {
        List<int[]> pictures = new ArrayList<>();
        PlacedLevel placed = PlacedLevel.of(levels.get(0), MAPS);
        try (Offscreen offscreen = new Offscreen(160, 120)) {
            Renderer renderer = LevelRenderer.load(offscreen.gl, Scene.of(placed, BakedLight.open()), SETTINGS);
            for (Level level : levels) {
                placed = placed.edited(level);
                renderer = LevelRenderer.edited(renderer, renderer.scene().edited(placed, null));
                renderer.draw(view(offscreen), offscreen.picture);
                offscreen.gl.requireNoError("edit");
                pictures.add(offscreen.pixels());
            }
            renderer.close();
        }
        return pictures;
    }

    /** In a context of its own, where nothing of another version is at hand. */
    private static int[] opened(Level level) {
        PlacedLevel placed = PlacedLevel.of(level, MAPS);
        try (Offscreen offscreen = new Offscreen(160, 120);
                Renderer renderer = LevelRenderer.load(offscreen.gl, Scene.of(placed, BakedLight.open()), SETTINGS)) {
            renderer.draw(view(offscreen), offscreen.picture);
            return offscreen.pixels();
        }
    }
}
