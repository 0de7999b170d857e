package nephele.workshop.prove.edits;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.Solid;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.scene.light.bake.BakedLight;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The data derived from an edited level equal those of the freshly loaded level, bit for bit. */
@Execution(ExecutionMode.CONCURRENT)
class EditedTownTest {
    private static final AssetSource ASSETS = smallPictures();

    /** Replaces the town's textures, which take most of a load to decode; no comparison reads a texel. */
    private static AssetSource smallPictures() {
        TestAssets assets = new TestAssets().committed("models/vase.obj");
        for (Material material : Town.of(1, 1, 1).materials()) {
            assets.picture(material.texture(), 8, 8, (x, y) -> 0x808080);
            if (material.normalTexture() != null) {
                assets.picture(material.normalTexture(), 8, 8, (x, y) -> 0x8080ff);
            }
        }
        return assets;
    }

    /** Bakes the first few solids only, which is enough to represent the light of an earlier level. */
    static BakedLight bakedInPart(PlacedLevel placed) {
        Level level = placed.level();
        Level part = level.with(level.materials(), level.solids().subList(1, 5), List.of(), List.of());
        return EditedTown.baked(PlacedLevel.of(part, ASSETS));
    }

    /**
     * The derived data are compared after edits of every kind, including those that change which features a level
     * needs.
     */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void randomEditsGiveWhatAFreshLoadGives(long seed) {
        Level level = Town.of(seed, 2, 1);
        PlacedLevel placed = PlacedLevel.of(level, ASSETS);
        BakedLight baked = bakedInPart(placed);
        EditedTown town = EditedTown.of(placed, baked);
        RandomEdits edits = new RandomEdits(seed, level);
        List<RandomEdits.Kind> kinds = List.copyOf(EnumSet.allOf(RandomEdits.Kind.class));
        for (int i = 0; i < 20; i++) {
            RandomEdits.Kind kind = edits.oneOf(kinds);
            town = town.edited(edits.after(kind), baked);
            EditedTown fresh = EditedTown.of(PlacedLevel.of(town.placed().level(), ASSETS), baked);
            assertEquals(List.of(), Differences.of(town, fresh), "edit " + i + ", " + kind);
        }
    }

    /** The comparison detects a difference; otherwise the other tests would prove nothing. */
    @Test
    void anotherTownDiffers() {
        Level level = Town.of(1, 1, 1);
        EditedTown town = EditedTown.of(PlacedLevel.of(level, ASSETS), BakedLight.open());
        List<Solid> fewer = new ArrayList<>(level.solids());
        fewer.remove(7);
        EditedTown other =
                EditedTown.of(PlacedLevel.of(level.with(level.materials(), fewer), ASSETS), BakedLight.open());
        assertFalse(Differences.of(town, other).isEmpty());
    }
}
