package nephele.editor.draw;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.asset.AssetException;
import nephele.engine.level.Level;
import nephele.engine.level.Terrain;
import nephele.engine.level.TestLevel;
import nephele.engine.level.TestTerrain;
import org.junit.jupiter.api.Test;

/** Terrains lose what cannot be read: paint alone if it is their layer map, all if it is their heights. */
class LevelRepairTest {
    private static final Terrain SAID = TestTerrain.said("t", "heights.png");
    private static final Level LEVEL =
            new TestLevel().level().withTerrains(List.of(SAID.withLayerMap("paint.png"), SAID));

    private static AssetException unusable(String file) {
        return new AssetException(file, "is damaged", "save it again");
    }

    @Test
    void aTerrainWhosePaintIsUnusableIsDrawnWithoutPaint() {
        LevelRepair repair = new LevelRepair();
        assertSame(LEVEL, repair.of(LEVEL));
        assertTrue(repair.learn(LEVEL, unusable("paint.png")));
        assertEquals(List.of(SAID, SAID), repair.of(LEVEL).terrains());
        assertEquals(List.of("paint.png: is damaged; save it again"), repair.messages(LEVEL));
        Level bare = LEVEL.withTerrains(List.of(SAID));
        assertSame(bare.terrains(), repair.of(bare).terrains());
        assertEquals(List.of(), repair.messages(bare));
        assertFalse(repair.learn(LEVEL, unusable("paint.png")), "the same again");
    }

    @Test
    void aTerrainWithoutHeightsIsLeftOut() {
        LevelRepair repair = new LevelRepair();
        assertTrue(repair.learn(LEVEL, unusable("heights.png")));
        assertEquals(List.of(), repair.of(LEVEL).terrains());
    }
}
