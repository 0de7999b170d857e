package nephele.engine.render;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.render.gl.BareFrame;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.View;

/**
 * The same pictures as a {@link Renderer}'s by the least OpenGL: the same shaders, textures, target and visible
 * triangles, one draw for each material batch, everything decided beforehand. {@code bench --bare} measures it.
 */
public final class BareTwin implements AutoCloseable {
    private final List<BareFrame> frames = new ArrayList<>();

    /** Draws every view once with {@code renderer}, which must stay open as long as this, and remembers how. */
    public BareTwin(GlContext gl, Renderer renderer, List<View> views, RenderTarget picture) {
        // What is drawn once and kept, as shadow maps, is no part of a frame.
        renderer.draw(views.get(0), picture);
        for (View view : views) {
            frames.add(BareFrame.record(gl, () -> renderer.draw(view, picture)));
        }
    }

    /** Draws every frame of something else once; what they draw with must stay open as long as this. */
    public BareTwin(GlContext gl, List<Runnable> engineFrames) {
        engineFrames.forEach(frame -> frames.add(BareFrame.record(gl, frame)));
    }

    /** Draws view number {@code frame}, wrapping around. */
    public void draw(int frame) {
        frames.get(Math.floorMod(frame, frames.size())).draw();
    }

    @Override
    public void close() {
        frames.forEach(BareFrame::close);
    }
}
