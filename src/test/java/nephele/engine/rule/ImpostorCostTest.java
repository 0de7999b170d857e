package nephele.engine.rule;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Level;
import nephele.engine.level.ModelPlacement.TransformStep.Scale;
import nephele.engine.level.Problem;
import nephele.engine.level.TestLevel;
import nephele.engine.level.billboard.PlantedModels;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** Each kind of impostor has pictures: 150 kinds took 28 s and a gigabyte, and a file may name ten thousand. */
class ImpostorCostTest {
    private static List<Problem> problems(int kinds, int ofEach) {
        Level level = level(kinds, ofEach);
        List<Problem> found = new ArrayList<>();
        ModelRules.IMPOSTOR_COST.check().apply(level, null, StaticShapes.of(level, TestAssets.NONE), found::add);
        return found;
    }

    private static Level level(int kinds, int ofEach) {
        TestLevel level = new TestLevel();
        for (int i = 0; i < kinds * ofEach; i++) {
            level.impostor("cone_1_3_3_1.3d", null, new Scale(new Vec3(1, 1 + i % kinds, 1)));
        }
        return level.level();
    }

    @Test
    void manyKindsOfImpostorsAreWarnedOfWithAnEstimate() {
        assertEquals(List.of(), problems(50, 4));
        List<Problem> told = problems(100, 1);
        assertEquals(1, told.size());
        assertEquals("models", told.get(0).path());
        assertTrue(told.get(0).message().startsWith("100 impostors of 100 kinds need some 17 s"), told.toString());
        assertTrue(told.get(0).message().contains("600 MB"), told.toString());
    }

    @Test
    void moreKindsThanALevelHasAreRefusedBeforeTheirPicturesAreMade() {
        assertTrue(problems(501, 1).get(0).isError());
        Level level = level(501, 1);
        StaticShapes statics = StaticShapes.of(level, TestAssets.NONE);
        AssetException told =
                assertThrows(AssetException.class, () -> PlantedModels.of(level, statics, TestAssets.NONE));
        assertTrue(told.getMessage().contains("at most 500 kinds"), told.getMessage());
    }
}
