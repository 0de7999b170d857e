package nephele.engine.scene;

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
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** Parts of a scene that an edit does not affect stay the same objects. */
class EditedSceneTest {
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
