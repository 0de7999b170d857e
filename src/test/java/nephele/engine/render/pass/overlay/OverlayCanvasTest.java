package nephele.engine.render.pass.overlay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.render.gl.DisplayColour;
import org.junit.jupiter.api.Test;

class OverlayCanvasTest {
    private static final DisplayColour WHITE = DisplayColour.opaque(0xffffff);
    private final OverlayCanvas canvas = new OverlayCanvas(new FontAtlas());

    @Test
    void aRectangleIsMeasuredInPointsAndStoredInPixels() {
        canvas.begin(2);
        canvas.rectangle(10, 20, 30, 40, WHITE);
        assertEquals(1, canvas.quads());
        assertEquals(20, canvas.vertices()[0]);
        assertEquals(40, canvas.vertices()[1]);
        assertEquals(80, canvas.vertices()[2 * OverlayCanvas.FLOATS_PER_VERTEX]);
        assertEquals(120, canvas.vertices()[2 * OverlayCanvas.FLOATS_PER_VERTEX + 1]);
    }

    @Test
    void textEndsWhereItsWidthSays() {
        canvas.begin(1.5);
        double end = canvas.text(100, 50, 20, WHITE, "Ação às 10");
        assertEquals(100 + canvas.width(20, "Ação às 10"), end, 1e-9);
        assertEquals("Açãoàs10".length(), canvas.quads());
    }

    @Test
    void aBaselineLiesOnAWholePixel() {
        canvas.begin(1);
        canvas.text(0, 50.4, 20, WHITE, "H");
        double bottom = canvas.vertices()[2 * OverlayCanvas.FLOATS_PER_VERTEX + 1];
        double texel = 20 / FontAtlas.TEXELS_PER_EM;
        assertEquals(50, bottom - FontAtlas.baselineTexels() * texel, 1e-4);
    }

    @Test
    void beginEmptiesAndCountsUp() {
        canvas.begin(1);
        canvas.text(0, 0, 10, WHITE, "x".repeat(1000));
        long before = canvas.version();
        canvas.begin(1);
        assertTrue(canvas.isEmpty());
        assertTrue(canvas.version() > before);
    }
}
