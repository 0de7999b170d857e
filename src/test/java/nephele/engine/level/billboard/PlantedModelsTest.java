package nephele.engine.level.billboard;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Billboards;
import nephele.engine.level.Level;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.ModelPlacement.TransformStep;
import nephele.engine.level.ModelPlacement.TransformStep.Rotate;
import nephele.engine.level.ModelPlacement.TransformStep.Scale;
import nephele.engine.level.ModelPlacement.TransformStep.Translate;
import nephele.engine.level.TestLevel;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Test;

/** Where models with impostors stand, and which of them are of one kind. */
class PlantedModelsTest {
    private static final Vec3 UP = new Vec3(0, 1, 0);

    private static PlantedModels planted(Level level) {
        return PlantedModels.of(level, StaticShapes.of(level, TestAssets.NONE), TestAssets.NONE);
    }

    private static ModelPlacement field(int count) {
        return new ModelPlacement("f", "cone_1_3_6_1.3d", null, List.of(), null, false)
                .over(new Billboards.Field(null, 5, count, 2, null, 90, null), 0.5);
    }

    private static TestLevel ground() {
        return new TestLevel().box(null, new Vec3(0, -0.5, 0), new Vec3(60, 1, 40));
    }

    @Test
    void aFieldStandsOnTheGroundApartAndTurned() {
        List<PlantedModels.Plant> plants =
                planted(ground().planted(field(100)).level()).plants();
        assertEquals(100, plants.size());
        double turns = 0;
        for (PlantedModels.Plant plant : plants) {
            assertEquals(0, plant.foot().y(), 1e-9);
            assertTrue(plant.scale() > 0.5 && plant.scale() <= 1);
            turns += plant.turn() / (2 * Math.PI * plants.size());
            for (PlantedModels.Plant other : plants) {
                assertTrue(other == plant || other.foot().minus(plant.foot()).length() >= 2);
            }
        }
        assertEquals(0.5, turns, 0.1);
    }

    /** What is planted is neither solid nor in the way of the sky, and leaves the other models as they are. */
    @Test
    void aFieldIsNotSolid() {
        Level level = ground().planted(field(10)).model("box_1_1.3d", null).level();
        StaticShapes statics = StaticShapes.of(level, TestAssets.NONE);
        assertTrue(statics.models().all().get(0).isEmpty());
        assertEquals(12, statics.models().all().get(1).triangles().count());
        assertEquals(0.5, statics.bounds().maxY(), 1e-9);
        double top =
                PlantedModels.reach(statics).stream().mapToDouble(Vec3::y).max().orElseThrow();
        assertTrue(top >= 3);
    }

    @Test
    void turnedScaledAndMovedModelsAreOfOneKind() {
        TransformStep[] steps = {
            new Translate(new Vec3(3, 1, -2)),
            new Rotate(UP, 77),
            new Scale(new Vec3(2, 2, 2)),
            new Rotate(new Vec3(1, 0, 0), 20)
        };
        TransformStep[] others = {new Rotate(UP, -140), new Rotate(new Vec3(1, 0, 0), 20)};
        Level level = new TestLevel()
                .impostor("cone_1_3_6_1.3d", null, steps)
                .impostor("cone_1_3_6_1.3d", null, others)
                .impostor("cone_1_3_6_1.3d", null)
                .level();
        PlantedModels planted = planted(level);
        assertEquals(2, planted.kinds().size());
        assertEquals(planted.plants().get(0).kind(), planted.plants().get(1).kind());
        List<PlacedModel> placed =
                StaticShapes.of(level, TestAssets.NONE).models().all();
        for (PlantedModels.Plant plant : planted.plants()) {
            Matrix4d frame =
                    plant.worldFromPlant().mul(planted.kinds().get(plant.kind()).plantFromModel());
            assertTrue(frame.equals(placed.get(plant.model()).worldFromModel(), 1e-8));
        }
    }
}
