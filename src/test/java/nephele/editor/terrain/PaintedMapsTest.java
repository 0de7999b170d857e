package nephele.editor.terrain;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import nephele.engine.asset.HeightMap;
import nephele.engine.level.Level;
import nephele.engine.level.Terrain;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

class PaintedMapsTest {
    private final PaintedMaps maps = new PaintedMaps(Optional::empty);

    private String show() {
        return maps.show(PaintedMaps.PaintedMap.of(new HeightMap(2, 2, 16, new short[4])));
    }

    private static Level level(String map) {
        Terrain terrain = new Terrain(
                "hills", map, Vec3.ZERO, new Terrain.Sides(8, 8), new Terrain.HeightRange(0, 1), List.of(), false);
        return Level.of("", "", null, List.of()).withTerrains(List.of(terrain));
    }

    /** A picture is drawn on another thread, and a fast stroke makes many maps until that asks for the one it shows. */
    @Test
    void theMapOfThePictureThatIsDrawnIsKeptWhileTheStrokeGoesOn() {
        String first = show();
        maps.drawing(level(first));
        String second = show();
        for (int i = 0; i < 20; i++) {
            show();
        }
        assertTrue(maps.known(first).isPresent());
        assertFalse(maps.known(second).isPresent(), "others are forgotten");
        String last = show();
        maps.drawing(level(last));
        show();
        assertFalse(maps.known(first).isPresent(), "its picture is drawn");
        assertTrue(maps.known(last).isPresent());
    }
}
