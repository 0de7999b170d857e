package nephele.editor.draw;

import static nephele.editor.draw.TestFrames.box;
import static nephele.editor.draw.TestFrames.level;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import nephele.editor.draw.LightProgress.Stage;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Camera;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Material;
import nephele.engine.level.Sky;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.bake.BakedLight;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What begins a bake behind the editor, what ends it, and what is drawn meanwhile. */
class EditedLightTest {
    private static final Solid FLOOR = box("floor", Vec3.ZERO, new Vec3(0.5, 0.2, 0.5), false);
    private static final Solid POST = box("post", new Vec3(0, 0.25, 0), new Vec3(0.1, 0.3, 0.1), true);
    private static final Solid MOVED = box("post", new Vec3(0.1, 0.25, 0), new Vec3(0.1, 0.3, 0.1), true);
    private static final Solid PORTALABLE = box("floor", Vec3.ZERO, new Vec3(0.5, 0.2, 0.5), true);
    private static final Light LAMP = new Light.Point("lamp", new Vec3(0, 2, 2), new Vec3(5, 5, 5), 9, true);
    private static final Level FIRST = level(FLOOR, POST);

    @TempDir
    Path folder;

    private final Deque<Runnable> soon = new ArrayDeque<>();
    private final Deque<Runnable> baking = new ArrayDeque<>();
    private AssetSource assets;
    private EditedLight light;
    private PlacedLevel placed;
    /** Called at the next repaint. */
    private Runnable whenRepainted = () -> {};

    @BeforeEach
    void open() {
        assets = new TestFrames.NoFiles(folder);
        placed = PlacedLevel.of(FIRST, assets);
        light = opened();
    }

    private EditedLight opened() {
        return new EditedLight(new BackgroundWork(soon::add, baking::add, () -> whenRepainted.run()));
    }

    private void follow(Level level, boolean bakes) {
        placed = placed.edited(level);
        follow(bakes);
    }

    /** Follows the version as the frames do that it is drawn in, until its key is known. */
    private void follow(boolean bakes) {
        light.follow(placed, bakes, Vec3.ZERO);
        if (bakes && !soon.isEmpty()) {
            soon.poll().run();
            light.follow(placed, true, Vec3.ZERO);
        }
    }

    /** Runs everything that waits. */
    private BakedLight ready() {
        for (Deque<Runnable> some = soon; !soon.isEmpty() || !baking.isEmpty(); some = some == soon ? baking : soon) {
            while (!some.isEmpty()) {
                some.poll().run();
            }
        }
        return light.light();
    }

    /** Returns true if a version of the level begins new work. */
    private boolean begins(Level level) {
        while (!soon.isEmpty()) {
            soon.poll().run();
        }
        follow(level, true);
        return !soon.isEmpty();
    }

    @Test
    void aLevelWhoseLightIsNotWantedHasOnlyItsSky() {
        follow(FIRST, false);
        assertNull(ready().indirect());
        assertFalse(light.isKnown());
        assertEquals(LightProgress.NONE, light.progress());
    }

    @Test
    void whatLightDependsOnBeginsABakeAnew() {
        assertTrue(begins(FIRST));
        Camera camera = new Camera("c", Vec3.ZERO, new Vec3(0, 0, -1), new Vec3(0, 1, 0), 60, 0, 0.1, 100, List.of());
        Level elsewhere =
                Level.of("other", "name", FIRST.environment(), List.of(camera)).with(FIRST.materials(), FIRST.solids());
        assertFalse(begins(elsewhere), "a camera");
        Level exposed = FIRST.with(FIRST.environment().with(Exposure.AUTO), List.of());
        assertFalse(begins(exposed), "an exposure");
        assertFalse(begins(level(PORTALABLE, POST)), "a surface for portals");
        assertEquals(1, baking.size());
        assertTrue(begins(level(FLOOR, MOVED)), "a solid");
        assertTrue(begins(FIRST.with(FIRST.environment(), List.of(LAMP))), "a lamp");
        assertTrue(
                begins(FIRST.with(FIRST.environment().with(new Sky.Constant(new Vec3(1, 1, 1))), List.of())), "a sky");
        Material red = new Material("red", new Vec3(1, 0, 0), null, null, null, null, Vec3.ZERO, 1);
        Solid painted = new Solid.Box(
                "post", "red", true, TextureMapping.WORLD, new Vec3(0, 0.25, 0), new Vec3(0.1, 0.3, 0.1), Map.of());
        assertTrue(begins(FIRST.with(List.of(red), List.of(FLOOR, painted))), "a material");
    }

    @Test
    void formerLightStaysUntilOtherIsReady() {
        follow(FIRST, true);
        BakedLight first = ready();
        assertNotNull(first.indirect());
        follow(level(FLOOR, MOVED), true);
        assertSame(first, light.light());
        soon.poll().run();
        assertSame(first, light.light(), "the sky alone is less than there was");
        assertEquals(Stage.COARSE, light.progress().stage());
        BakedLight[] coarse = new BakedLight[1];
        whenRepainted = () -> coarse[0] = coarse[0] == null && light.light() != first ? light.light() : coarse[0];
        BakedLight second = ready();
        assertNotNull(coarse[0].indirect());
        assertSame(coarse[0].visibility(), second.visibility(), "what is drawn is not made anew");
        assertTrue(coarse[0].indirect() != second.indirect());
        assertTrue(second.isOf(placed.statics().solids()));
        follow(level(FLOOR, MOVED), false);
        assertNotNull(ready().indirect(), "light of this very level stays when no more is baked");
        follow(FIRST.with(FIRST.environment(), List.of(LAMP)), true);
        soon.poll().run();
        follow(FIRST.with(FIRST.environment(), List.of(LAMP)), false);
        assertNull(ready().indirect(), "that of another one does not");
    }

    @Test
    void aFinishedBakeIsFoundAgainAndAnEndedOneLeavesNothing() {
        whenRepainted = () -> light.close();
        follow(FIRST, true);
        assertNull(ready().indirect());
        light = opened();
        whenRepainted = () -> {};
        light.follow(placed, false, Vec3.ZERO);
        assertNull(ready().indirect());
        assertFalse(light.isKnown());
        follow(true);
        assertNotNull(ready().indirect());
        light = opened();
        light.follow(placed, false, Vec3.ZERO);
        soon.poll().run();
        assertNotNull(light.light().indirect());
        assertTrue(light.isKnown());
        follow(true);
        assertTrue(soon.isEmpty() && baking.isEmpty(), "it is there already");
    }

    @Test
    void theEditIsWhereSomethingDiffers() {
        PlacedLevel moved = placed.edited(level(FLOOR, MOVED));
        Vec3 between = new Vec3(0.05, 0.25, 0);
        Supplier<Vec3> found = () -> EditedLight.placeOfEdit(placed, moved).orElseThrow();
        assertEquals(0, found.get().minus(between).length(), 1e-9);
        Vec3 gone = EditedLight.placeOfEdit(moved, moved.edited(level(FLOOR))).orElseThrow();
        assertEquals(0, gone.minus(new Vec3(0.1, 0.25, 0)).length(), 1e-9);
        PlacedLevel lit = placed.edited(FIRST.with(FIRST.environment(), List.of(LAMP)));
        assertEquals(Optional.of(LAMP.position()), EditedLight.placeOfEdit(placed, lit));
        assertEquals(Optional.empty(), EditedLight.placeOfEdit(placed, placed));
    }
}
