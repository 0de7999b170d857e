package nephele.editor.window.viewport;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Semaphore;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlUnavailableException;
import org.junit.jupiter.api.Test;

/** The surface without a display: the tests' JVM is headless. */
class ViewportSurfaceGlTest {
    private final FillPainter painter = new FillPainter();
    private final ViewportSurface surface = new ViewportSurface(painter, GlContext::offscreen);

    private static int pixel(BufferedImage picture, int x, int y) {
        return picture.getRGB(x, y) & 0xffffff;
    }

    private static BufferedImage paint(ViewportSurface surface) {
        BufferedImage screen = new BufferedImage(50, 50, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = screen.createGraphics();
        surface.component().paint(graphics);
        graphics.dispose();
        return screen;
    }

    @Test
    void aPictureIsDrawnBesideTheThreadThatShowsIt() {
        surface.component().setSize(40, 30);
        BufferedImage picture = surface.picture();
        assertEquals(40, picture.getWidth());
        assertEquals(30, picture.getHeight());
        assertEquals(0x0000ff, pixel(picture, 5, 5), "rows are from above");
        assertEquals(0xff3300, pixel(picture, 5, 25));
        assertEquals(new SurfaceSize(40, 30, 1), surface.size());
        assertEquals(0xff3300, pixel(paint(surface), 39, 29));
        surface.close();
        assertEquals(Map.of(), withoutNone(surface));
        assertEquals(
                List.of("next 40 x 30", "beside: opened", "beside: painted", "told", "beside: closing"),
                painter.events);
    }

    private static Map<?, Integer> withoutNone(ViewportSurface surface) {
        Map<?, Integer> left = new java.util.HashMap<>(surface.liveObjects());
        left.values().removeIf(count -> count == 0);
        return left;
    }

    /** The last picture stays while the next one is drawn; what changes meanwhile is in the one after it. */
    @Test
    void swingShowsTheLastPictureWhileTheNextIsDrawn() throws Exception {
        surface.component().setSize(20, 10);
        surface.picture();
        Semaphore goOn = new Semaphore(0);
        CountDownLatch drawing = new CountDownLatch(1);
        painter.before = () -> {
            drawing.countDown();
            assertFalse(EventQueue.isDispatchThread());
            goOn.acquireUninterruptibly();
        };
        painter.red = 0;
        surface.repaintSoon();
        EventQueue.invokeAndWait(() -> paint(surface));
        drawing.await();
        EventQueue.invokeAndWait(() -> {
            assertEquals(0xff3300, pixel(paint(surface), 3, 9));
            surface.repaintSoon();
            assertEquals(0xff3300, pixel(paint(surface), 3, 9));
        });
        goOn.release(2);
        EventQueue.invokeAndWait(() -> {
            assertEquals(0x003300, pixel(surface.picture(), 3, 9));
            assertEquals(0x003300, pixel(paint(surface), 3, 9));
        });
        assertEquals(
                3, painter.events.stream().filter("beside: painted"::equals).count());
        surface.close();
    }

    /** Closing the surface completes the future of a picture that is still being drawn. */
    @Test
    void aPictureThatIsDrawnAtTheEndIsWaitedForByNobody() throws Exception {
        surface.component().setSize(20, 10);
        Semaphore goOn = new Semaphore(0);
        painter.before = goOn::acquireUninterruptibly;
        EventQueue.invokeAndWait(() -> {
            paint(surface);
            assertFalse(surface.drawing().isDone());
            surface.close();
            assertTrue(surface.drawing().isDone());
        });
        goOn.release();
        surface.closed().join();
        assertEquals(Map.of(), withoutNone(surface));
    }

    @Test
    void itDrawsOnlyWhenAskedOrResizedAndLeaksNothing() throws Exception {
        EventQueue.invokeAndWait(() -> {
            surface.component().setSize(20, 10);
            surface.picture();
            Map<?, Integer> live = surface.liveObjects();
            paint(surface);
            surface.component().setSize(30, 20);
            paint(surface);
            surface.picture();
            painter.red = 0;
            assertEquals(0xff3300, pixel(paint(surface), 29, 19));
            assertEquals(live, surface.liveObjects());
            surface.close();
        });
        assertEquals(Map.of(), withoutNone(surface));
        assertEquals(
                List.of("beside: next 20 x 10", "beside: next 30 x 20", "beside: next 30 x 20"),
                painter.events.stream().filter(event -> event.contains("next")).toList());
    }

    @Test
    void aFailureWhileDrawingKeepsTheLastPicture() {
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
        ViewportSurface without = new ViewportSurface(painter, () -> {
            throw new GlUnavailableException("no OpenGL here");
        });
        without.component().setSize(20, 10);
        without.picture();
        assertEquals(0, pixel(without.picture(), 3, 9));
        assertEquals(List.of("next 20 x 10", "failed: no OpenGL here"), painter.events);
        without.close();
    }
}
