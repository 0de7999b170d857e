package nephele.editor.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlUnavailableException;
import org.junit.jupiter.api.Test;

/** The surface without a display: the tests' JVM is headless. */
class OffscreenSurfaceGlTest {
    private final FillPainter painter = new FillPainter();
    private final List<String> reports = new ArrayList<>();

    private static int pixel(BufferedImage picture, int x, int y) {
        return picture.getRGB(x, y) & 0xffffff;
    }

    @Test
    void withoutADisplayThePictureIsDrawnOffscreen() {
        ViewportSurface surface = ViewportSurfaces.choose(SurfaceMode.AUTO, painter, reports::add);
        surface.component().setSize(40, 30);
        BufferedImage picture = surface.picture();
        assertEquals(40, picture.getWidth());
        assertEquals(30, picture.getHeight());
        assertEquals(0x0000ff, pixel(picture, 5, 5), "rows are from above");
        assertEquals(0xff3300, pixel(picture, 5, 25));
        assertEquals(new SurfaceSize(40, 30, 1), surface.size());
        surface.close();
        assertEquals(List.of("opened", "painted 40 x 30", "closing"), painter.events);
        assertEquals(List.of(), reports);
    }

    @Test
    void aCanvasThatCannotBeIsExplained() {
        ViewportSurfaces.choose(SurfaceMode.AWT, painter, reports::add).close();
        assertEquals(List.of("the viewport is drawn offscreen: there is no display"), reports);
    }

    @Test
    void itDrawsOnlyWhenAskedOrResizedAndLeaksNothing() {
        OffscreenSurface surface = new OffscreenSurface(painter, GlContext::offscreen);
        BufferedImage screen = new BufferedImage(50, 50, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = screen.createGraphics();
        surface.component().setSize(20, 10);
        surface.component().paint(graphics);
        int live = painter.live();
        surface.component().paint(graphics);
        assertEquals(0x0000ff, pixel(screen, 19, 0));
        surface.component().setSize(30, 20);
        surface.component().paint(graphics);
        surface.repaintSoon();
        painter.red = 0;
        surface.component().paint(graphics);
        assertEquals(0x003300, pixel(screen, 29, 19));
        assertEquals(live, painter.live());
        graphics.dispose();
        surface.close();
        assertEquals(0, painter.live());
        assertEquals(
                List.of("opened", "painted 20 x 10", "painted 30 x 20", "painted 30 x 20", "closing"), painter.events);
    }

    @Test
    void aFailureWhileDrawingKeepsTheLastPicture() {
        OffscreenSurface surface = new OffscreenSurface(painter, GlContext::offscreen);
        surface.component().setSize(20, 10);
        surface.picture();
        painter.failure = new IllegalStateException("as planned");
        assertEquals(0xff3300, pixel(surface.picture(), 3, 9));
        assertTrue(painter.events.contains("failed: as planned"), painter.events.toString());
        painter.failure = null;
        painter.red = 0;
        assertEquals(0x003300, pixel(surface.picture(), 3, 9));
        surface.close();
    }

    @Test
    void aMissingOpenGlIsReportedOnce() {
        OffscreenSurface surface = new OffscreenSurface(painter, () -> {
            throw new GlUnavailableException("no OpenGL here");
        });
        surface.component().setSize(20, 10);
        surface.picture();
        assertEquals(0, pixel(surface.picture(), 3, 9));
        assertEquals(List.of("failed: no OpenGL here"), painter.events);
        surface.close();
    }
}
