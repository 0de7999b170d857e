package nephele.lab.prove;

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
import nephele.engine.scene.light.SkyVisibility;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What follows from an edited level is, to the last bit, what follows from it when it is loaded. */
@Execution(ExecutionMode.CONCURRENT)
class EditedTownTest {
    private static final AssetSource ASSETS = smallPictures();

    /** Decoding the town's own takes most of a load, and no comparison looks at a texel. */
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

    /** Of the first few solids alone, which is enough of a light that is an earlier level's. */
    static SkyVisibility bakedInPart(PlacedLevel placed) {
        Level level = placed.level();
        Level part = level.with(level.materials(), level.solids().subList(1, 5), List.of(), List.of());
        return EditedTown.baked(PlacedLevel.of(part, ASSETS));
    }

    /** Edits of every kind, also those that change what a level needs; each is compared. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void randomEditsGiveWhatAFreshLoadGives(long seed) {
        Level level = Town.of(seed, 2, 1);
        PlacedLevel placed = PlacedLevel.of(level, ASSETS);
        SkyVisibility baked = bakedInPart(placed);
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

    /** A comparison that finds nothing would prove nothing. */
    @Test
    void anotherTownDiffers() {
        Level level = Town.of(1, 1, 1);
        EditedTown town = EditedTown.of(PlacedLevel.of(level, ASSETS), SkyVisibility.open());
        List<Solid> fewer = new ArrayList<>(level.solids());
        fewer.remove(7);
        EditedTown other =
                EditedTown.of(PlacedLevel.of(level.with(level.materials(), fewer), ASSETS), SkyVisibility.open());
        assertFalse(Differences.of(town, other).isEmpty());
    }
}
