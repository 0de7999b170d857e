package nephele.engine.render.pass.overlay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.render.gl.DisplayColour;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class OverlayPassGlTest {
    private static final DisplayColour WHITE = DisplayColour.opaque(0xffffff);
    private final FontAtlas letters = new FontAtlas();
    private GlContext gl;
    private RenderTarget picture;
    private OverlayPass pass;

    @BeforeEach
    void open() {
        gl = GlContext.offscreen();
        picture = RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, 200, 100);
        pass = new OverlayPass(gl, letters);
        picture.clear(0, 0, 0);
    }

    @AfterEach
    void close() {
        pass.close();
        picture.close();
        gl.close();
    }

    @Test
    void anEmptyCanvasBuildsNothing() {
        var before = gl.live().counts();
        pass.draw(new OverlayCanvas(letters), picture);
        assertFalse(pass.isBuilt());
        assertEquals(before, gl.live().counts());
    }

    @Test
    void aRectangleCoversItsPixelsAndNoOther() {
        var canvas = new OverlayCanvas(letters);
        canvas.begin(1);
        canvas.rectangle(20, 10, 30, 40, WHITE);
        pass.draw(canvas, picture);
        var bytes = picture.readBytes();
        for (int y = 0; y < 100; y++) {
            for (int x = 0; x < 200; x++) {
                boolean inside = x >= 20 && x < 50 && y >= 10 && y < 50;
                assertEquals(inside ? 255 : 0, bytes.get(4 * ((99 - y) * 200 + x)) & 255, x + ", " + y);
            }
        }
    }

    @Test
    void alphaMixesWithThePicture() {
        var canvas = new OverlayCanvas(letters);
        canvas.begin(1);
        canvas.rectangle(0, 0, 200, 100, WHITE.withAlpha(0.25));
        pass.draw(canvas, picture);
        assertEquals(64, picture.readBytes().get(0) & 255, 1);
    }

    @Test
    void whatIsCoveredShinesThroughByTheRest() {
        picture.clear(1, 1, 1);
        var canvas = new OverlayCanvas(letters);
        canvas.begin(1);
        canvas.rectangle(0, 0, 200, 100, DisplayColour.opaque(0).withAlpha(0.25));
        pass.draw(canvas, picture);
        assertEquals(191, picture.readBytes().get(0) & 255, 1);
    }

    /** The stem of an l is a rectangle with round ends, so its inked area is known. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1.5, 2})
    void aStemHasTheInkOfItsPen(double scale) {
        var canvas = new OverlayCanvas(letters);
        canvas.begin(scale);
        canvas.text(20, 40, 40, WHITE, "|");
        pass.draw(canvas, picture);
        double em = 40 * scale;
        double pen = em * StrokeFont.PEN_HUNDREDTHS / 100;
        double expected = em * pen + Math.PI * pen * pen / 4;
        assertEquals(expected, ink(), 0.03 * expected);
    }

    @Test
    void theSameCanvasIsUploadedOnceAndAChangedOneAgain() {
        var canvas = new OverlayCanvas(letters);
        canvas.begin(1);
        canvas.rectangle(0, 0, 10, 10, WHITE);
        pass.draw(canvas, picture);
        canvas.begin(1);
        canvas.rectangle(0, 0, 20, 10, WHITE);
        picture.clear(0, 0, 0);
        pass.draw(canvas, picture);
        assertEquals(200, ink(), 0.5);
    }

    @Test
    void closingGivesEveryObjectBack() {
        var before = gl.live().counts();
        var canvas = new OverlayCanvas(letters);
        canvas.begin(1);
        canvas.text(0, 20, 10, WHITE, "Olá");
        try (var another = new OverlayPass(gl, letters)) {
            another.draw(canvas, picture);
            assertTrue(another.isBuilt());
        }
        assertEquals(before, gl.live().counts());
        gl.requireNoError("overlay");
    }

    private double ink() {
        var bytes = picture.readBytes();
        double sum = 0;
        for (int pixel = 0; pixel < 200 * 100; pixel++) {
            sum += (bytes.get(4 * pixel) & 255) / 255.0;
        }
        return sum;
    }
}
