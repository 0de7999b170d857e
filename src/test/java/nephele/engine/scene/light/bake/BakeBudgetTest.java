package nephele.engine.scene.light.bake;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.scene.light.ShadowTest;
import org.junit.jupiter.api.Test;

/** Bakes cast all of their rays if that is within the budget, and fewer otherwise. */
class BakeBudgetTest {
    private static final double[] ABOVE = {0, 2, 0};
    private static final double[] DOWN = {0, -1, 0};
    private static final List<Brush> BOX = List.of(ShadowTest.box(0, 0, 0, 1, 1, 1));

    /** One ray tests the tree's one node and its one item. */
    @Test
    void raysAreDividedWhereAllPlacesTogetherTestTooManyBoxes() {
        int most = (int) (BakeBudget.MOST_BOX_TESTS / 2 * 0.999);
        assertEquals(1, divisor(most));
        assertEquals(2, divisor((int) (1.01 * most)));
        assertEquals(2, divisor(2 * most));
        assertEquals(8, divisor(5 * most));
    }

    private static int divisor(int places) {
        BakeBudget ration = new BakeBudget(new Occluders(BOX));
        return ration.divisor(1, places, item -> assertTrue(ration.isOccluded(ABOVE, DOWN, -1)));
    }

    @Test
    void theSightOfTheSampleIsThatOfTheBake() {
        Occluders occluders = new Occluders(BOX);
        BakeBudget ration = new BakeBudget(occluders);
        for (double[] ray : List.of(DOWN, new double[] {0, 1, 0}, new double[] {0.4, -2, 0}, new double[] {1, -1, 0})) {
            assertEquals(occluders.isOccluded(ABOVE, ray, -1), ration.isOccluded(ABOVE, ray, -1));
            assertEquals(occluders.isOccluded(ABOVE, ray, 0), ration.isOccluded(ABOVE, ray, 0));
        }
    }

    @Test
    void aSmallLevelIsBakedInFull() {
        StaticShapes room =
                StaticShapes.of(List.of(ShadowTest.box(0, -0.5, 0, 4, 1, 4), ShadowTest.box(0, 0.5, 0, 1, 1, 1)));
        LightMapLayout layout = LightMapLayout.of(room.solids());
        assertArrayEquals(
                SkyVisibility.bake(room, done -> {}).texels(),
                SkyVisibility.bake(layout, room, true, done -> {}).texels());
    }
}
