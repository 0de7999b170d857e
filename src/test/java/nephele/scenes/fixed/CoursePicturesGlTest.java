package nephele.scenes.fixed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntPredicate;
import javax.imageio.ImageIO;
import nephele.engine.asset.ResourceAssets;
import nephele.engine.render.Capture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.scenes.fixed.FixedSceneDrawing.Source;
import nephele.scenes.fixed.FixedSceneDrawing.Sources;
import nephele.scenes.xml.XmlScene;
import nephele.scenes.xml.XmlSceneFile;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A course's scenes look like the pictures that the course publishes. */
class CoursePicturesGlTest {
    private static final String FOLDER = "/nephele/scenes/fixed/course";
    private static final int SIZE = 512;
    private static final int TITLE_ROWS = 31;

    /** Size of the window's round corners, which cover the picture. */
    private static final int CORNER_PIXELS = 8;

    private static final SceneAppearance WIREFRAME =
            SceneAppearance.USUAL.with(Shading.WIREFRAME).withAxes(true);

    /**
     * Each pixel of a line has one of the published picture within a pixel, and vice versa; also by colour, except
     * where edges and axes coincide in space.
     */
    @ParameterizedTest
    @CsvSource({
        "test_1_1, 1, 512, ANY",
        "test_1_3, 1, 512, EACH",
        "test_1_5, 1, 512, EACH",
        "test_2_4, 0, 511, EACH",
        "test_3_2, 1, 512, EACH"
    })
    void linesAgreeToOnePixel(String name, int frameColumns, int rows, Colours colours) throws IOException {
        int[] theirs = published(name, frameColumns, rows);
        int[] ours = drawn(name, WIREFRAME, rows);
        assertLinesAgree(ours, theirs, rgb -> rgb != 0);
        if (colours == Colours.EACH) {
            for (int colour : new int[] {0xffffff, 0xff0000, 0x00ff00, 0x0000ff}) {
                assertLinesAgree(ours, theirs, rgb -> rgb == colour);
            }
        }
    }

    /** The compared pixels: lines of any colour, or also those of each colour alone. */
    private enum Colours {
        ANY,
        EACH
    }

    /**
     * The difference is 6/255 outside edges; the lit tip of the teapot's lid has the exact normal here and a black one
     * in the published picture.
     */
    @Test
    void litColoursAgree() throws IOException {
        int[] theirs = published("test_4_3", 1, SIZE);
        int[] ours = drawn("test_4_3", SceneAppearance.USUAL.withAxes(true), SIZE);
        List<String> off = new ArrayList<>();
        int compared = 0;
        for (int i = 0; i < ours.length; i++) {
            boolean tip = Math.hypot(i % SIZE - 240, i / SIZE - 174) < 3.5;
            if (isCorner(i, SIZE) || tip || isEdge(ours, i) || isEdge(theirs, i)) {
                continue;
            }
            compared += theirs[i] == 0 ? 0 : 1;
            if (difference(ours[i], theirs[i]) > 6) {
                off.add(String.format("(%d, %d): %06x, theirs %06x", i % SIZE, i / SIZE, ours[i], theirs[i]));
            }
        }
        assertEquals(List.of(), off);
        assertTrue(compared > 45_000, compared + " lit pixels compared");
        assertLinesAgree(ours, theirs, rgb -> rgb != 0);
    }

    private static void assertLinesAgree(int[] ours, int[] theirs, IntPredicate isLine) {
        assertNear(ours, theirs, isLine, "ours has none of theirs beside it");
        assertNear(theirs, ours, isLine, "theirs has none of ours beside it");
    }

    private static void assertNear(int[] from, int[] to, IntPredicate isLine, String complaint) {
        int rows = from.length / SIZE;
        List<String> alone = new ArrayList<>();
        int lines = 0;
        for (int i = 0; i < from.length; i++) {
            if (isLine.test(from[i]) && !isCorner(i, rows)) {
                lines++;
                if (!hasNeighbour(to, i, isLine)) {
                    alone.add("(" + i % SIZE + ", " + i / SIZE + ")");
                }
            }
        }
        assertEquals(List.of(), alone, complaint);
        assertTrue(lines > 300, lines + " pixels of lines");
    }

    private static boolean isCorner(int i, int rows) {
        int x = i % SIZE;
        return i / SIZE >= rows - CORNER_PIXELS && (x < CORNER_PIXELS || x >= SIZE - CORNER_PIXELS);
    }

    private static boolean hasNeighbour(int[] picture, int at, IntPredicate wanted) {
        for (int i : around(picture, at)) {
            if (wanted.test(picture[i])) {
                return true;
            }
        }
        return false;
    }

    /** Returns true at a discontinuity of colour. */
    private static boolean isEdge(int[] picture, int at) {
        for (int i : around(picture, at)) {
            if (difference(picture[i], picture[at]) > 40) {
                return true;
            }
        }
        return false;
    }

    private static int[] around(int[] picture, int at) {
        int x = at % SIZE;
        int y = at / SIZE;
        int rows = picture.length / SIZE;
        int[] found = new int[9];
        int count = 0;
        for (int row = Math.max(0, y - 1); row <= Math.min(rows - 1, y + 1); row++) {
            for (int column = Math.max(0, x - 1); column <= Math.min(SIZE - 1, x + 1); column++) {
                found[count++] = row * SIZE + column;
            }
        }
        return Arrays.copyOf(found, count);
    }

    private static int difference(int a, int b) {
        int red = Math.abs((a >> 16) - (b >> 16));
        int green = Math.abs((a >> 8 & 255) - (b >> 8 & 255));
        return Math.max(Math.max(red, green), Math.abs((a & 255) - (b & 255)));
    }

    /** Returns the client area, 0xrrggbb, the top row first. */
    private static int[] published(String name, int frameColumns, int rows) throws IOException {
        try (var in = CoursePicturesGlTest.class.getResourceAsStream(FOLDER + "/" + name + ".png")) {
            return pixels(ImageIO.read(in), frameColumns, TITLE_ROWS, rows);
        }
    }

    private static int[] drawn(String name, SceneAppearance look, int rows) {
        var assets = new ResourceAssets(FOLDER);
        List<String> complaints = new ArrayList<>();
        XmlScene scene = XmlSceneFile.read(name, assets.bytes(name + ".xml"));
        var sources = new Sources(new Source(scene, new SceneFolder(name, assets, complaints::add)), null, null);
        try (var gl = GlContext.offscreen();
                var target = RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, SIZE, SIZE);
                var drawing = FixedSceneDrawing.load(gl, sources)) {
            drawing.draw(FixedSceneDrawing.view(scene.eye(), 1), 0, new Matrix4d(), look, target);
            gl.requireNoError(name);
            assertEquals(List.of(), complaints);
            assertEquals(List.of(), scene.warnings());
            return pixels(Capture.image(target), 0, 0, rows);
        }
    }

    private static int[] pixels(BufferedImage image, int x, int y, int rows) {
        int[] rgb = image.getRGB(x, y, SIZE, rows, null, 0, SIZE);
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] &= 0xffffff;
        }
        return rgb;
    }
}
