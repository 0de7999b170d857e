package nephele.editor.draw;

import static nephele.editor.draw.TestFrames.AHEAD;
import static nephele.editor.draw.TestFrames.HEIGHT;
import static nephele.editor.draw.TestFrames.WIDTH;
import static nephele.editor.draw.TestFrames.box;
import static nephele.editor.draw.TestFrames.level;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import nephele.editor.draw.TestFrames.NoFiles;
import nephele.editor.mark.Mark;
import nephele.editor.mark.Mark.Visibility;
import nephele.editor.mark.MarkColour;
import nephele.editor.pane.PaneCamera;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.pane.PlanCamera;
import nephele.editor.pane.ViewMode;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.BoxFace;
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
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlKind;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Pictures of the viewport; pixels count from the upper left corner. */
class ViewportDrawingGlTest {
    private static final Solid WALL = box("wall", new Vec3(0, 1, -0.5), new Vec3(4, 2, 1), true);
    private static final Solid DARK_WALL = box("dark", new Vec3(0, 1, -0.5), new Vec3(4, 2, 1), false);
    private static final int BACKGROUND = 0x1e2227;

    @TempDir
    static Path folder;

    private final Deque<Runnable> later = new ArrayDeque<>();
    private int repaints;
    private GlContext gl;
    private RenderTarget target;
    private ViewportDrawing drawing;
    private AssetSource assets;

    @BeforeEach
    void open() {
        gl = GlContext.offscreen();
        target = RenderTarget.picture(gl, "viewport", PixelFormat.RGBA8, WIDTH, HEIGHT);
        drawing = new ViewportDrawing(gl, later::add, () -> repaints++);
        assets = new NoFiles(folder);
    }

    @AfterEach
    void close() {
        gl.requireNoError("the viewport");
        drawing.close();
        target.close();
        Map<GlKind, Integer> left = gl.live().counts();
        gl.close();
        left.values().forEach(count -> assertEquals(0, count, left.toString()));
    }

    private int[] picture(Level level, PaneCamera camera, ViewMode mode, Mark... marks) {
        drawing.draw(TestFrames.frame(level, assets, camera, mode, List.of(marks)), target);
        return pixels();
    }

    private int[] pixels() {
        int[] fromBelow = new int[WIDTH * HEIGHT];
        target.readRgb(fromBelow);
        int[] pixels = new int[fromBelow.length];
        for (int y = 0; y < HEIGHT; y++) {
            System.arraycopy(fromBelow, y * WIDTH, pixels, (HEIGHT - 1 - y) * WIDTH, WIDTH);
        }
        return pixels;
    }

    private static int at(int[] picture, int x, int y) {
        return picture[y * WIDTH + x] & 0xffffff;
    }

    private static int brightness(int rgb) {
        return (rgb >> 16 & 255) + (rgb >> 8 & 255) + (rgb & 255);
    }

    @Test
    void anUnlitWallStandsOutFromTheBackgroundWithoutAnyLight() {
        int[] picture = picture(level(WALL), AHEAD, ViewMode.UNLIT);
        assertTrue(brightness(at(picture, 100, 75)) > 3 * brightness(BACKGROUND));
        assertEquals(BACKGROUND, at(picture, 190, 10));
    }

    @Test
    void portalableFacesAreMuchBrighterThanOthers() {
        int portalable = brightness(at(picture(level(WALL), AHEAD, ViewMode.PORTALABLE), 100, 75));
        int other = brightness(at(picture(level(DARK_WALL), AHEAD, ViewMode.PORTALABLE), 100, 75));
        assertTrue(portalable > 2 * other, portalable + " of " + other);
    }

    @Test
    void aFaceOnAMirrorIsNotShownAsPortalable() {
        Material mirror = new Material("m", new Vec3(1, 1, 1), null, null, null, null, Vec3.ZERO, 1, true);
        Solid.Face face = new Solid.Face("m", null, null);
        Solid.Box wall = new Solid.Box(
                "w",
                null,
                true,
                TextureMapping.WORLD,
                new Vec3(0, 1, -0.5),
                new Vec3(4, 2, 1),
                Map.of(BoxFace.PLUS_Z, face));
        int mirrored = at(picture(level().with(List.of(mirror), List.of(wall)), AHEAD, ViewMode.PORTALABLE), 100, 75);
        assertEquals(at(picture(level(DARK_WALL), AHEAD, ViewMode.PORTALABLE), 100, 75), mirrored);
    }

    @Test
    void collisionShowsKindsInDifferentColours() {
        ModelPlacement model = new ModelPlacement("m", "box_2_2.3d", null, List.of(), null, false);
        Level models = level().with(List.of(), List.of(), List.of(), List.of(model));
        int solid = at(picture(level(WALL), AHEAD, ViewMode.COLLISION), 100, 75);
        int other =
                at(picture(models, new PerspectiveCamera(new Vec3(0, 0, 5), 0, 0, 60), ViewMode.COLLISION), 100, 75);
        assertNotEquals(solid, other);
        assertNotEquals(BACKGROUND, other);
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

    private static Mark.Line across(double z, Visibility visibility) {
        return new Mark.Line(new Vec3(-1, 1, z), new Vec3(1, 1, z), MarkColour.SELECTED, visibility);
    }

    @Test
    void marksInFrontOfAWallAreVisibleAndThoseBehindAreHidden() {
        Level level = level(WALL);
        int[] plain = picture(level, AHEAD, ViewMode.UNLIT);
        int[] front = picture(level, AHEAD, ViewMode.UNLIT, across(0.5, Visibility.HIDDEN_BY_SURFACES));
        int[] on = picture(level, AHEAD, ViewMode.UNLIT, across(0, Visibility.HIDDEN_BY_SURFACES));
        int[] behind = picture(level, AHEAD, ViewMode.UNLIT, across(-2, Visibility.HIDDEN_BY_SURFACES));
        int[] always = picture(level, AHEAD, ViewMode.UNLIT, across(-2, Visibility.ALWAYS));
        assertNotEquals(at(plain, 100, 75), at(front, 100, 75));
        assertNotEquals(at(plain, 100, 75), at(on, 100, 75));
        assertNotEquals(at(plain, 100, 75), at(always, 100, 75));
        assertTrue(Arrays.equals(plain, behind));
    }

    @Test
    void surfacesHideMarksInLinearLightToo() {
        Level level = level(WALL);
        Level auto = level.with(level.environment().with(Exposure.AUTO), List.of());
        picture(auto, new PerspectiveCamera(new Vec3(0, 1, 5), 180, 0, 60), ViewMode.LIT);
        int[] plain = picture(auto, AHEAD, ViewMode.LIT);
        int[] front = picture(auto, AHEAD, ViewMode.LIT, across(0.5, Visibility.HIDDEN_BY_SURFACES));
        int[] behind = picture(auto, AHEAD, ViewMode.LIT, across(-2, Visibility.HIDDEN_BY_SURFACES));
        assertNotEquals(at(plain, 100, 75), at(front, 100, 75));
        assertArrayEquals(plain, behind);
    }

    @Test
    void marksAreWhereTheCameraProjectsThemAlsoFarFromTheOrigin() {
        Vec3 far = new Vec3(3e6, 0, -2e6);
        PerspectiveCamera camera = new PerspectiveCamera(far.plus(new Vec3(0.3, 0.2, 4)), 10, -5, 60);
        int[] plain = picture(level(), camera, ViewMode.WIREFRAME);
        int[] marked = picture(level(), camera, ViewMode.WIREFRAME, new Mark.Handle(far, MarkColour.PREVIEW));
        var spot = camera.project(far, new PaneCamera.PaneSize(WIDTH, HEIGHT)).orElseThrow();
        assertEquals(spot.x(), middle(plain, marked)[0], 1);
        assertEquals(spot.y(), middle(plain, marked)[1], 1);
    }

    private static double[] middle(int[] some, int[] others) {
        double x = 0;
        double y = 0;
        int count = 0;
        for (int i = 0; i < some.length; i++) {
            if (some[i] != others[i]) {
                x += i % WIDTH + 0.5;
                y += i / WIDTH + 0.5;
                count++;
            }
        }
        return new double[] {x / count, y / count};
    }

    @Test
    void anAreaIsTranslucentAndALabelIsBesideItsPoint() {
        Mark area = new Mark.Polygon(
                List.of(new Vec3(-1, 0.5, 1), new Vec3(1, 0.5, 1), new Vec3(0, 1.5, 1)),
                MarkColour.REFUSED,
                Visibility.HIDDEN_BY_SURFACES);
        Level level = level(WALL);
        int[] plain = picture(level, AHEAD, ViewMode.UNLIT);
        int under = at(plain, 100, 75);
        int over = at(picture(level, AHEAD, ViewMode.UNLIT, area), 100, 75);
        assertTrue((over >> 16 & 255) - (over & 255) > (under >> 16 & 255) - (under & 255) + 10);
        Mark label = new Mark.Label(new Vec3(0, 1, 1), "12,5 m", MarkColour.GUIDE);
        double[] at = middle(plain, picture(level, AHEAD, ViewMode.UNLIT, label));
        assertTrue(at[0] > 105 && at[0] < 160 && at[1] > 45 && at[1] < 75, at[0] + ", " + at[1]);
    }

    @Test
    void aPlanShowsTheEdgesOfASolidWithinAPixel() {
        PlanCamera top = new PlanCamera(PaneKind.TOP, Vec3.ZERO, 0.02);
        Solid box = box("b", new Vec3(0.05, 0, 0.05), new Vec3(1, 1, 0.6), false);
        int[] plain = picture(level(), top, ViewMode.LIT);
        int[] drawn = picture(level(box), top, ViewMode.LIT);
        // x from −0.45 to 0.55 and z from −0.25 to 0.35, 50 pixels to a metre.
        for (int y = 25; y < HEIGHT; y++) {
            for (int x = 40; x < WIDTH; x++) {
                boolean isEdge = isNear(x, 77.5, y, 62.5, 92.5)
                        || isNear(x, 127.5, y, 62.5, 92.5)
                        || isNear(y, 62.5, x, 77.5, 127.5)
                        || isNear(y, 92.5, x, 77.5, 127.5);
                assertTrue(isEdge || at(plain, x, y) == at(drawn, x, y), x + ", " + y);
            }
        }
        assertEdge(plain, drawn, 77, 80);
        assertEdge(plain, drawn, 127, 80);
    }

    private static boolean isNear(int pixel, double line, int along, double from, double to) {
        return Math.abs(pixel + 0.5 - line) <= 1.5 && along >= from - 2 && along <= to + 2;
    }

    private static void assertEdge(int[] plain, int[] drawn, int x, int y) {
        boolean isThere = false;
        for (int near = x - 1; near <= x + 1; near++) {
            isThere |= at(plain, near, y) != at(drawn, near, y);
        }
        assertTrue(isThere, x + ", " + y);
    }

    @Test
    void aWireframeShowsEdgesWithoutSurfaces() {
        int[] picture = picture(level(WALL), AHEAD, ViewMode.WIREFRAME);
        assertEquals(BACKGROUND, at(picture, 100, 70));
        var corner = AHEAD.project(new Vec3(0, 2, 0), new PaneCamera.PaneSize(WIDTH, HEIGHT))
                .orElseThrow();
        boolean isThere = false;
        for (int y = (int) corner.y() - 1; y <= (int) corner.y() + 1; y++) {
            isThere |= brightness(at(picture, 100, y)) > 2 * brightness(BACKGROUND);
        }
        assertTrue(isThere);
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
            try (ViewportDrawing fresh = new ViewportDrawing(gl, later::add, () -> {})) {
                fresh.draw(TestFrames.frame(level, assets, camera, mode, List.of()), target);
                assertTrue(Arrays.equals(edited, pixels()), mode + " of edit " + edits.indexOf(level));
            }
        }
        int[] first = picture(edits.get(0), camera, mode);
        Map<GlKind, Integer> counts = gl.live().counts();
        for (Level level : edits) {
            picture(level, camera, mode);
        }
        assertTrue(Arrays.equals(first, picture(edits.get(0), camera, mode)));
        assertEquals(counts, gl.live().counts());
    }

    @Test
    void aPaneWhoseContentIsTheSameKeepsItsPicture() {
        Level level = level(WALL);
        int[] first = picture(level, AHEAD, ViewMode.UNLIT);
        gl.state().resetCounts();
        assertTrue(Arrays.equals(first, picture(level, AHEAD, ViewMode.UNLIT)));
        assertEquals(0, gl.state().draws());
    }

    @Test
    void theLightOfTheSkyIsBakedOutsideOfTheFrame() {
        Solid floor = box("floor", new Vec3(0, -0.5, 0), new Vec3(8, 1, 8), false);
        Level level = level(box("wall", new Vec3(0, 1, -0.5), new Vec3(4, 2, 1), true), floor);
        int[] open = picture(level, AHEAD, ViewMode.LIT);
        assertEquals(1, later.size());
        later.poll().run();
        assertEquals(1, repaints);
        assertTrue(later.isEmpty());
        int[] baked = picture(level, AHEAD, ViewMode.LIT);
        int under = 95;
        assertTrue(brightness(at(baked, 100, under)) < brightness(at(open, 100, under)), "the wall darkens the floor");
        assertTrue(later.isEmpty(), "nothing has changed since");
    }

    /** The placed level has the sun of its hour, and so is another object than the level of the frame. */
    @Test
    void aLevelUnderAnAtmosphereIsPlacedOnce() {
        Level level = level(WALL);
        level = level.with(level.environment().with(Sky.Atmosphere.CLEAR), List.of());
        DrawnLevel drawn = new DrawnLevel(gl, assets, Background.DARK, later::add, () -> repaints++);
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
        List<String> messages = new ArrayList<>(drawing.messages());
        assertTrue(messages.removeIf(line -> line.startsWith("no.png: ")), messages.toString());
        assertTrue(messages.removeIf(line -> line.startsWith("no-n.png: ")), messages.toString());
        assertTrue(messages.removeIf(line -> line.startsWith("no.obj: ")), messages.toString());
        assertTrue(messages.removeIf(line -> line.startsWith("no.vol: ")), messages.toString());
        assertTrue(messages.removeIf(line -> line.startsWith("no-map.png: ")), messages.toString());
        assertTrue(messages.removeIf(line -> line.startsWith("solids/open: ")), messages.toString());
        assertEquals(List.of(), messages);
        picture(level(WALL), AHEAD, ViewMode.LIT);
        assertEquals(List.of(), drawing.messages());
    }
}
