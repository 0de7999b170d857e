package nephele.engine.render.pass.terrain;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntBinaryOperator;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
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
import nephele.engine.scene.light.bake.SkyVisibility;
import org.junit.jupiter.api.Test;

/** After an edit of heights the picture is the one of a level that was opened so: shadows, the sky's light, triangles. */
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
            .file("d.r16", map((column, row) -> 65535 - TestTerrain.wavy(column, row)));

    /** Its records are the same in all versions, so that an edit changes the terrain alone. */
    private static final Level BASE = new TestLevel()
            .castingSun(new Vec3(0.8, 0.35, 0.3), 3)
            .sky(new Sky.Constant(new Vec3(0.4, 0.6, 0.9)))
            .material("wall", new Vec3(0.7, 0.7, 0.7))
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
        List<String> maps = List.of("a.r16", "b.r16", "c.r16", "a.r16", "d.r16");
        List<int[]> edited = edited(maps);
        for (int i = 0; i < maps.size(); i++) {
            assertArrayEquals(opened(maps.get(i)), edited.get(i), maps.get(i));
            assertFalse(i > 0 && Arrays.equals(edited.get(i - 1), edited.get(i)), maps.get(i) + " is seen");
        }
    }

    private static List<int[]> edited(List<String> maps) {
        List<int[]> pictures = new ArrayList<>();
        PlacedLevel placed = PlacedLevel.of(level(maps.get(0)), MAPS);
        try (Offscreen offscreen = new Offscreen(160, 120)) {
            Renderer renderer = Renderer.load(offscreen.gl, Scene.of(placed, SkyVisibility.open()), SETTINGS);
            for (String map : maps) {
                placed = placed.edited(level(map));
                renderer = renderer.edited(renderer.scene().edited(placed, null));
                renderer.draw(view(offscreen), offscreen.picture);
                offscreen.gl.requireNoError(map);
                pictures.add(offscreen.pixels());
            }
            renderer.close();
        }
        return pictures;
    }

    /** In a context of its own, where nothing of another version is at hand. */
    private static int[] opened(String map) {
        PlacedLevel placed = PlacedLevel.of(level(map), MAPS);
        try (Offscreen offscreen = new Offscreen(160, 120);
                Renderer renderer = Renderer.load(offscreen.gl, Scene.of(placed, SkyVisibility.open()), SETTINGS)) {
            renderer.draw(view(offscreen), offscreen.picture);
            return offscreen.pixels();
        }
    }
}
