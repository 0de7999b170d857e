package nephele.editor.draw;

import static nephele.editor.draw.TestFrames.AHEAD;
import static nephele.editor.draw.TestFrames.HEIGHT;
import static nephele.editor.draw.TestFrames.WIDTH;
import static nephele.editor.draw.TestFrames.box;
import static nephele.editor.draw.TestFrames.level;
import static nephele.editor.draw.TestViewport.at;
import static nephele.editor.draw.TestViewport.brightness;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import nephele.editor.pane.Mark;
import nephele.editor.pane.Mark.Visibility;
import nephele.editor.pane.MarkColour;
import nephele.editor.pane.PaneCamera;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.pane.PlanCamera;
import nephele.editor.pane.ViewMode;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Pictures of the viewport; pixels count from the upper left corner. */
class ViewportDrawingGlTest {
    private static final Solid WALL = box("wall", new Vec3(0, 1, -0.5), new Vec3(4, 2, 1), true);
    private static final Solid DARK_WALL = box("dark", new Vec3(0, 1, -0.5), new Vec3(4, 2, 1), false);
    private static final int BACKGROUND = 0x1e2227;

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
}
