package nephele.engine.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import nephele.engine.asset.TestAssets;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.level.TestLevel;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Aabb;
import nephele.engine.math.ItemList;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What follows from an edited level is, to the last bit, what follows from it when it is loaded. */
class EditedLevelTest {
    private static Level town() {
        TestLevel town = new TestLevel()
                .ambient(1)
                .material("grey", TestLevel.grey(0.5))
                .material("red", new Vec3(0.8, 0.1, 0.1))
                .box("grey", new Vec3(5, -0.5, 5), new Vec3(12, 1, 12));
        for (int i = 0; i < 25; i++) {
            town.box(i % 3 == 0 ? "red" : "grey", new Vec3(2 * (i % 5), 1, 2 * (i / 5)), new Vec3(2, 2, 2));
        }
        return town.level();
    }

    private static Solid moved(Solid solid, Random random) {
        Solid.Box box = (Solid.Box) solid;
        Vec3 centre = box.centre();
        double step = random.nextInt(3) - 1;
        return new Solid.Box(
                box.id(),
                random.nextBoolean() ? "red" : box.material(),
                box.portalable(),
                box.textureMapping(),
                new Vec3(centre.x() + step / 2, centre.y(), centre.z() + step),
                box.size(),
                box.faces());
    }

    private static Level edit(Level level, Random random) {
        List<Solid> solids = new ArrayList<>(level.solids());
        int at = random.nextInt(solids.size());
        switch (random.nextInt(4)) {
            case 0 -> solids.remove(at);
            case 1 -> solids.add(at, moved(solids.get(at), random));
            default -> solids.set(at, moved(solids.get(at), random));
        }
        return level.with(level.materials(), solids);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void randomEditsGiveWhatAFreshLoadGives(long seed) {
        Random random = new Random(seed);
        List<Level> past = new ArrayList<>(List.of(town()));
        PlacedLevel placed = PlacedLevel.of(past.get(0), TestAssets.NONE);
        Scene scene = Scene.of(placed, null);
        CollisionWorld world = CollisionWorld.of(placed.statics());
        for (int i = 0; i < 40; i++) {
            Level level = random.nextInt(5) == 0 ? past.get(random.nextInt(past.size())) : edit(placed.level(), random);
            past.add(level);
            placed = placed.edited(level);
            scene = scene.edited(placed, null);
            world = world.edited(placed.statics());
            PlacedLevel fresh = PlacedLevel.of(level, TestAssets.NONE);
            assertSameGeometry(Scene.of(fresh, null).solids(), scene.solids(), "edit " + i);
            assertSameWorld(CollisionWorld.of(fresh.statics()), world, "edit " + i);
        }
    }

    private static void assertSameGeometry(SolidGeometry expected, SolidGeometry actual, String edit) {
        assertEquals(expected.solids().vertices(), actual.solids().vertices(), edit);
        assertEquals(expected.solids().indices(), actual.solids().indices(), edit);
        assertEquals(expected.origin(), actual.origin(), edit);
        assertEquals(expected.slotCount(), actual.slotCount(), edit);
        assertEquals(expected.batches().size(), actual.batches().size(), edit);
        for (int batch = 0; batch < expected.batches().size(); batch++) {
            SolidBatch one = expected.batches().get(batch);
            SolidBatch other = actual.batches().get(batch);
            assertEquals(one.kind(), other.kind(), edit);
            assertEquals(one.cellOrigin(), other.cellOrigin(), edit);
            for (int slot = 0; slot <= expected.slotCount(); slot++) {
                assertEquals(one.start(slot), other.start(slot), edit);
            }
        }
    }

    private static void assertSameWorld(CollisionWorld expected, CollisionWorld actual, String edit) {
        assertEquals(expected.size(), actual.size(), edit);
        assertEquals(expected.extent(), actual.extent(), edit);
        ItemList one = new ItemList();
        ItemList other = new ItemList();
        for (int x = 0; x < 10; x++) {
            Aabb box = new Aabb(x, 0, x / 2.0, x + 1, 1, x + 1);
            expected.overlapping(box, one);
            actual.overlapping(box, other);
            assertEquals(one.size(), other.size(), edit);
            for (int i = 0; i < one.size(); i++) {
                assertEquals(one.get(i), other.get(i), edit);
                assertEquals(
                        expected.collider(one.get(i)).bounds(),
                        actual.collider(other.get(i)).bounds(),
                        edit);
            }
        }
    }

    @Test
    void whatAnEditLeavesStaysTheSameObject() {
        Level level = town();
        PlacedLevel placed = PlacedLevel.of(level, TestAssets.NONE);
        Scene scene = Scene.of(placed, null);
        CollisionWorld world = CollisionWorld.of(placed.statics());
        List<Solid> solids = new ArrayList<>(level.solids());
        solids.set(3, moved(solids.get(3), new Random(7)));
        PlacedLevel other = placed.edited(level.with(level.materials(), solids));
        assertSame(placed.statics().solids().get(5), other.statics().solids().get(5));
        assertNotSame(placed.statics().solids().get(3), other.statics().solids().get(3));
        assertSame(world.collider(5), world.edited(other.statics()).collider(5));
        assertSame(scene.materials(), scene.edited(other, null).materials());
        PlacedLevel elsewhere = placed.edited(level.withPortals(List.of()));
        assertSame(placed.statics(), elsewhere.statics());
        assertSame(scene.solids(), scene.edited(elsewhere, null).solids());
        assertSame(world, world.edited(elsewhere.statics()));
    }
}
