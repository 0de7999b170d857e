package nephele.lab.trade.subject;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import nephele.engine.asset.Picture;
import nephele.engine.level.Billboards;
import nephele.engine.level.Level;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.billboard.PlantedBillboards;
import nephele.engine.level.billboard.PlantedModels;
import nephele.engine.level.billboard.PlantedModels.Plant;
import nephele.engine.level.billboard.Sprite;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Aabb;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Test;

/** Sprites stand where the models stand that they replace, as large as these, and show them. */
class PlantSpritesTest {
    private final PlacedLevel placed = PlantedTrees.opened().placed();
    private final PlantSprites sprites = PlantSprites.of(placed);

    /** Returns the box around a plant's mesh in the world. */
    private static Aabb box(PlantedModels planted, Plant plant) {
        PlantedModels.Kind kind = planted.kinds().get(plant.kind());
        Matrix4d frame = plant.worldFromPlant().mul(kind.plantFromModel());
        return WorldTriangles.of(kind.mesh(), frame).bounds();
    }

    @Test
    void eachStandsAndEndsWhereItsModelDoes() {
        Level level = sprites.in(placed.level(), Billboards.Facing.CROSSED);
        assertTrue(level.models().stream().noneMatch(ModelPlacement::impostor), "no tree is drawn twice");
        PlantedModels planted = PlantedModels.of(placed.level(), placed.statics(), placed.assets());
        List<PlantedBillboards.Group> groups =
                PlantedBillboards.of(level, placed.statics(), sprites.assets()).groups();
        assertEquals(10, planted.plants().size());
        assertEquals(2, groups.size());
        int number = 0;
        for (PlantedBillboards.Group group : groups) {
            assertEquals(Billboards.Facing.CROSSED, group.authored().facing());
            for (int i = 0; i < group.feet().size(); i++) {
                Plant plant = planted.plants().get(number++);
                Aabb box = box(planted, plant);
                double height = group.authored().sizeMetres().height() * group.scale(i);
                double width = group.authored().sizeMetres().width() * group.scale(i);
                assertEquals(box.minY(), group.feet().get(i).y(), 1e-6);
                assertEquals(box.maxY(), group.feet().get(i).y() + height, 1e-6);
                // The upright cylinder around the kind holds it however it is turned.
                double longest = Math.max(box.maxX() - box.minX(), box.maxZ() - box.minZ());
                assertTrue(width >= longest - 1e-6 && width < 1.35 * longest, width + " m for " + longest + " m");
                assertEquals(box.centre().x(), group.feet().get(i).x(), 0.15 * width);
                assertEquals(box.centre().z(), group.feet().get(i).z(), 0.15 * width);
            }
        }
        assertEquals(10, number);
    }

    @Test
    void thePictureIsTheTreeFromFootToTop() {
        Picture picture =
                Sprite.of(sprites.groups().get(0), sprites.assets()).frames().get(0);
        assertEquals(480, picture.width());
        assertEquals(480, picture.height());
        IntPredicate row = y -> IntStream.range(0, 480).anyMatch(x -> picture.sample(x, y, 3) > 0);
        IntPredicate column = x -> IntStream.range(0, 480).anyMatch(y -> picture.sample(x, y, 3) > 0);
        assertTrue(row.test(0) || row.test(1) || row.test(2), "its top is a leaf's tip, within three rows");
        assertTrue(row.test(479), "its foot is in the lowest row");
        long columns = IntStream.range(0, 480).filter(column).count();
        assertTrue(columns > 300, "across it is seen in " + columns + " columns");
        double share = mean(picture, 3);
        assertTrue(share > 0.25 && share < 0.85, "covered " + share);
        assertTrue(mean(picture, 1) > mean(picture, 2) + 0.05, "it is green");
        assertTrue(
                covered(picture, 470) < covered(picture, 160) / 4,
                "the trunk is below, the crown above: not upside down");
    }

    private static double mean(Picture picture, int channel) {
        double sum = 0;
        for (int i = 0; i < picture.width() * picture.height(); i++) {
            sum += picture.sample(i % picture.width(), i / picture.width(), channel) / 255.0;
        }
        return sum / picture.width() / picture.height();
    }

    private static long covered(Picture picture, int y) {
        return IntStream.range(0, picture.width())
                .filter(x -> picture.sample(x, y, 3) > 127)
                .count();
    }
}
