package nephele.engine.render;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.render.gl.BareFrame;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.View;

/**
 * Draws the same pictures as a {@link Renderer} with the fewest OpenGL calls: the same shaders, textures, target and
 * visible triangles, one draw for each material batch, all decisions made beforehand. {@code bench --bare} measures it.
 */
public final class BareTwin implements AutoCloseable {
    private final List<BareFrame> frames = new ArrayList<>();

    /**
     * Draws every view once with {@code renderer} and records it; the renderer must stay open as long as this object.
     */
    public BareTwin(GlContext gl, Renderer renderer, List<View> views, RenderTarget picture) {
        // The first frame draws cached data such as shadow maps, which later frames do not repeat.
        renderer.draw(views.get(0), picture);
        for (View view : views) {
            frames.add(BareFrame.record(gl, () -> renderer.draw(view, picture)));
        }
    }

    /** Draws and records frames of another kind; the objects that they use must stay open as long as this object. */
    public BareTwin(GlContext gl, List<Runnable> engineFrames) {
        engineFrames.forEach(frame -> frames.add(BareFrame.record(gl, frame)));
    }

    /** Draws view number {@code frame}, modulo the number of views. */
    public void draw(int frame) {
        frames.get(Math.floorMod(frame, frames.size())).draw();
    }

    @Override
    public void close() {
        frames.forEach(BareFrame::close);
    }
}
