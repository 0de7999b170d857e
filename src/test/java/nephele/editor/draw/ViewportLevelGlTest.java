package nephele.editor.draw;

import static nephele.editor.draw.TestFrames.AHEAD;
import static nephele.editor.draw.TestFrames.box;
import static nephele.editor.draw.TestFrames.level;
import static nephele.editor.draw.TestViewport.at;
import static nephele.editor.draw.TestViewport.brightness;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import nephele.editor.pane.Mark;
import nephele.editor.pane.PaneCamera;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.pane.ViewMode;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.EditorNotes;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Sky;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlKind;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The viewport follows a level: its edits, its light, what is hidden in it and what cannot be drawn. */
class ViewportLevelGlTest {
    private static final Solid WALL = box("wall", new Vec3(0, 1, -0.5), new Vec3(4, 2, 1), true);

    @TempDir
    static Path folder;

    private TestViewport viewport;

    @BeforeEach
    void open() {
        viewport = new TestViewport(folder);
    }

    @AfterEach
    void close() {
        viewport.close();
    }

    private int[] picture(Level level, PaneCamera camera, ViewMode mode, Mark... marks) {
        return viewport.picture(level, camera, mode, marks);
    }

    /** Exposure auto shows each view as it calls for, at once; to and from a number of stops the picture follows. */
    @Test
    void exposureAutoIsMeteredInTheEditorToo() {
        Level dim = level(WALL);
        dim = dim.with(dim.environment().with(new Sky.Constant(new Vec3(4e-4, 4e-4, 4e-4))), List.of());
        Level auto = dim.with(dim.environment().with(Exposure.AUTO), List.of());
        PerspectiveCamera away = new PerspectiveCamera(new Vec3(0, 1, 5), 180, 0, 60);
        int[] first = picture(auto, AHEAD, ViewMode.LIT);
        int sky = brightness(at(first, 190, 10));
        assertTrue(sky > 150, "sky " + sky);
        assertTrue(brightness(at(picture(dim, AHEAD, ViewMode.LIT), 190, 10)) < 10);
        picture(auto, away, ViewMode.LIT);
        assertArrayEquals(first, picture(auto, AHEAD, ViewMode.LIT));
    }

    private List<Level> edits() {
        Material red = new Material("red", new Vec3(1, 0, 0), null, null, null, null, Vec3.ZERO, 1);
        Solid floor = box("floor", new Vec3(0, -0.5, 0), new Vec3(8, 1, 8), false);
        Solid moved = box("wall", new Vec3(1, 1.25, -1), new Vec3(3, 2, 1), true);
        Solid painted =
                new Solid.Prism("p", "red", false, TextureMapping.WORLD, new Vec3(-1, 1, 1), 0.5, 2, 6, Map.of());
        Light lamp = new Light.Point("lamp", new Vec3(0, 2, 2), new Vec3(5, 5, 5), 9, true);
        Level first = level(WALL, floor);
        Level second = first.with(List.of(), List.of(moved, floor));
        Level third = second.with(List.of(red), List.of(moved, floor, painted));
        Level fourth = third.with(third.environment(), List.of(lamp));
        EditorNotes hiding = new EditorNotes(List.of(), List.of("solids/wall"), List.of(), List.of());
        Level fifth = fourth.with(hiding);
        Level sixth = fifth.with(List.of(red), List.of(floor, painted));
        return List.of(first, second, third, fourth, fifth, sixth, first);
    }

    @ParameterizedTest
    @EnumSource
    void picturesAfterEditsAreThoseOfAFreshDrawing(ViewMode mode) {
        PaneCamera camera = new PerspectiveCamera(new Vec3(2, 3, 6), 15, -20, 60);
        List<Level> edits = edits();
        for (Level level : edits) {
            int[] edited = picture(level, camera, mode);
            try (ViewportDrawing fresh = new ViewportDrawing(viewport.gl, viewport.work)) {
                fresh.draw(TestFrames.frame(level, viewport.assets, camera, mode, List.of()), viewport.target);
                assertTrue(Arrays.equals(edited, viewport.pixels()), mode + " of edit " + edits.indexOf(level));
            }
        }
        int[] first = picture(edits.get(0), camera, mode);
        Map<GlKind, Integer> counts = viewport.gl.live().counts();
        for (Level level : edits) {
            picture(level, camera, mode);
        }
        assertTrue(Arrays.equals(first, picture(edits.get(0), camera, mode)));
        assertEquals(counts, viewport.gl.live().counts());
    }

    @Test
    void aPaneWhoseContentIsTheSameKeepsItsPicture() {
        Level level = level(WALL);
        int[] first = picture(level, AHEAD, ViewMode.UNLIT);
        viewport.gl.state().resetCounts();
        assertTrue(Arrays.equals(first, picture(level, AHEAD, ViewMode.UNLIT)));
        assertEquals(0, viewport.gl.state().draws());
    }

    @Test
    void theLightOfTheSkyIsBakedOutsideOfTheFrame() {
        Solid floor = box("floor", new Vec3(0, -0.5, 0), new Vec3(8, 1, 8), false);
        Level level = level(box("wall", new Vec3(0, 1, -0.5), new Vec3(4, 2, 1), true), floor);
        int[] open = picture(level, AHEAD, ViewMode.LIT);
        assertEquals(1, viewport.later.size());
        viewport.later.poll().run();
        assertEquals(1, viewport.repaints);
        assertTrue(viewport.later.isEmpty());
        int[] baked = picture(level, AHEAD, ViewMode.LIT);
        int under = 95;
        assertTrue(brightness(at(baked, 100, under)) < brightness(at(open, 100, under)), "the wall darkens the floor");
        assertTrue(viewport.later.isEmpty(), "nothing has changed since");
    }

    @Test
    void afterAnEditTheFormerLightStaysUntilTheNewOneIsBaked() {
        Material glow = new Material("glow", new Vec3(0, 0, 0), null, null, null, null, new Vec3(4, 4, 4), 1);
        Solid floor = box("floor", new Vec3(0, -0.1, 0), new Vec3(1, 0.2, 1), false);
        Solid lamp = lamp(0.4);
        PerspectiveCamera camera = new PerspectiveCamera(new Vec3(0, 0.8, 1.2), 0, -30, 50);
        Level level = level().with(List.of(glow), List.of(floor, lamp));
        Level moved = level.with(level.materials(), List.of(floor, lamp(-0.4)));
        int left = 50;
        int right = 150;
        int row = 85;
        int[] dark = viewport.baking(level, camera);
        runLater();
        viewport.baking(level, camera);
        runLater();
        int[] bright = viewport.baking(level, camera);
        assertTrue(
                brightness(at(bright, right, row)) > brightness(at(dark, right, row)) + 60,
                "the lamp lights the floor");
        assertTrue(brightness(at(bright, right, row)) > brightness(at(bright, left, row)) + 30, "most beside it");
        int[] edited = viewport.baking(moved, camera);
        // The charts have other borders now.
        assertEquals(brightness(at(bright, 100, row)), brightness(at(edited, 100, row)), 6);
        viewport.later.poll().run();
        viewport.baking(moved, camera);
        assertEquals(1, viewport.later.size());
        viewport.later.poll().run();
        assertArrayEquals(edited, viewport.baking(moved, camera), "the sky alone changes nothing");
        runLater();
        int[] baked = viewport.baking(moved, camera);
        assertTrue(
                brightness(at(baked, left, row)) > brightness(at(baked, right, row)) + 30, "it lights the other side");
    }

    private static Solid lamp(double x) {
        Vec3 centre = new Vec3(x, 0.1, -0.1);
        return new Solid.Box("lamp", "glow", false, TextureMapping.WORLD, centre, new Vec3(0.1, 0.2, 0.2), Map.of());
    }

    private void runLater() {
        while (!viewport.later.isEmpty()) {
            viewport.later.poll().run();
        }
    }

    /** The placed level has the sun of its hour, and so is another object than the level of the frame. */
    @Test
    void aLevelUnderAnAtmosphereIsPlacedOnce() {
        Level level = level(WALL);
        level = level.with(level.environment().with(Sky.Atmosphere.CLEAR), List.of());
        DrawnLevel drawn = new DrawnLevel(viewport.gl, viewport.assets, Background.DARK, viewport.work);
        drawn.show(level);
        PlacedLevel placed = drawn.placed();
        drawn.show(level);
        assertTrue(placed == drawn.placed(), "placed again");
        drawn.close();
    }

    @Test
    void hiddenCloudsAreNotDrawn() {
        Level sky = level(WALL);
        Cloud cloud = cloud(new Cloud.Density.Ellipsoid());
        Level cloudy = sky.with(sky.environment().withClouds(List.of(cloud)), List.of());
        int[] seen = picture(cloudy, AHEAD, ViewMode.LIT);
        EditorNotes hiding =
                new EditorNotes(List.of(), List.of("environment.clouds/" + cloud.id()), List.of(), List.of());
        int[] hidden = picture(cloudy.with(hiding), AHEAD, ViewMode.LIT);
        assertArrayEquals(picture(sky, AHEAD, ViewMode.LIT), hidden);
        assertNotEquals(at(hidden, 100, 75), at(seen, 100, 75));
    }

    private static Cloud cloud(Cloud.Density density) {
        Cloud.Extent extent = new Cloud.Extent.Volume(new Vec3(0, 1, 2), new Vec3(2, 2, 2));
        return new Cloud(density.toString(), extent, CloudTechnique.AUTO, density, 1, 1, 0);
    }

    @Test
    void whatCannotBeDrawnIsLeftOutAndReported() {
        Material missing = new Material("m", new Vec3(1, 1, 1), "no.png", null, null, "no-n.png", Vec3.ZERO, 1);
        Solid broken = new Solid.Planes(
                "open",
                null,
                false,
                TextureMapping.WORLD,
                List.of(new Solid.PlaneFace(new Vec3(0, 1, 0), 1, null, null, null)));
        ModelPlacement lost = new ModelPlacement("lost", "no.obj", null, List.of(), null, false);
        ModelPlacement onLost = new ModelPlacement("on", "box_1_1.3d", "lost", List.of(), null, false);
        Level ground = level().with(List.of(missing), List.of(WALL, broken), List.of(), List.of(lost, onLost));
        List<Cloud> clouds = List.of(
                cloud(new Cloud.Density.Grid("no.vol")),
                cloud(new Cloud.Density.Noise(1, 2, 0.9, 0, null, "no-map.png", 0)));
        Level level = ground.with(ground.environment().withClouds(clouds), List.of());
        for (ViewMode mode : ViewMode.values()) {
            int[] picture = picture(level, AHEAD, mode);
            assertTrue(Arrays.equals(picture(level(WALL), AHEAD, mode), picture), mode.toString());
        }
        picture(level, AHEAD, ViewMode.LIT);
        List<String> messages = new ArrayList<>(viewport.drawing.messages());
        assertTrue(messages.removeIf(line -> line.startsWith("no.png: ")), messages.toString());
        assertTrue(messages.removeIf(line -> line.startsWith("no-n.png: ")), messages.toString());
        assertTrue(messages.removeIf(line -> line.startsWith("no.obj: ")), messages.toString());
        assertTrue(messages.removeIf(line -> line.startsWith("no.vol: ")), messages.toString());
        assertTrue(messages.removeIf(line -> line.startsWith("no-map.png: ")), messages.toString());
        assertTrue(messages.removeIf(line -> line.startsWith("solids/open: ")), messages.toString());
        assertEquals(List.of(), messages);
        picture(level(WALL), AHEAD, ViewMode.LIT);
        assertEquals(List.of(), viewport.drawing.messages());
    }
}
