package nephele.editor.draw;

import static nephele.editor.draw.TestFrames.HEIGHT;
import static nephele.editor.draw.TestFrames.WIDTH;
import static nephele.editor.draw.TestFrames.level;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import nephele.editor.draw.TestFrames.NoFiles;
import nephele.editor.pane.Mark;
import nephele.editor.pane.PaneCamera;
import nephele.editor.pane.ViewMode;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlKind;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;

/** A viewport without a window, which draws one perspective pane; pixels count from the upper left corner. */
final class TestViewport implements AutoCloseable {
    int repaints;
    final Deque<Runnable> later = new ArrayDeque<>();
    final GlContext gl = GlContext.offscreen();
    final RenderTarget target = RenderTarget.picture(gl, "viewport", PixelFormat.RGBA8, WIDTH, HEIGHT);
    final BackgroundWork work = new BackgroundWork(later::add, later::add, () -> repaints++);
    final ViewportDrawing drawing = new ViewportDrawing(gl, work);
    final AssetSource assets;

    TestViewport(Path folder) {
        assets = new NoFiles(folder);
    }

    int[] picture(Level level, PaneCamera camera, ViewMode mode, Mark... marks) {
        drawing.draw(TestFrames.frame(level, assets, camera, mode, List.of(marks)), target);
        return pixels();
    }

    /** Draws a lit level whose bounced light is baked in the background. */
    int[] baking(Level level, PaneCamera camera) {
        ViewportFrame frame = TestFrames.frame(level, assets, camera, ViewMode.LIT, List.of());
        drawing.draw(
                new ViewportFrame(
                        level, assets, frame.panes(), 0, frame.marks(), frame.look(), frame.isSettled(), true),
                target);
        return pixels();
    }

    int[] pixels() {
        int[] fromBelow = new int[WIDTH * HEIGHT];
        target.readRgb(fromBelow);
        int[] pixels = new int[fromBelow.length];
        for (int y = 0; y < HEIGHT; y++) {
            System.arraycopy(fromBelow, y * WIDTH, pixels, (HEIGHT - 1 - y) * WIDTH, WIDTH);
        }
        return pixels;
    }

    static int at(int[] picture, int x, int y) {
        return picture[y * WIDTH + x] & 0xffffff;
    }

    static int brightness(int rgb) {
        return (rgb >> 16 & 255) + (rgb >> 8 & 255) + (rgb & 255);
    }

    /** Requires that no error happened and that nothing is left. */
    @Override
    public void close() {
        gl.requireNoError("the viewport");
        drawing.close();
        target.close();
        Map<GlKind, Integer> left = gl.live().counts();
        gl.close();
        left.values().forEach(count -> assertEquals(0, count, left.toString()));
    }
}
