package nephele.lab.bench;

import java.util.List;
import nephele.engine.level.Billboards;
import nephele.engine.level.Level;
import nephele.engine.render.Renderer;
import nephele.engine.render.Renderer.StepListener;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.View;

/** A level drawn by the engine along a camera path; particles and billboards move by 1/60 s in each frame of it. */
public record LevelDrawing(
        Renderer renderer, List<View> views, RenderTarget picture, FrameState state, boolean isAnimated)
        implements Drawing {
    private static final double FRAMES_PER_SECOND = 60;

    public LevelDrawing(Renderer renderer, List<View> views, RenderTarget picture) {
        this(
                renderer,
                views,
                picture,
                FrameState.atStart(renderer.scene().level()),
                isAnimated(renderer.scene().level()));
    }

    private static boolean isAnimated(Level level) {
        return !level.emitters().isEmpty() || level.billboards().stream().anyMatch(Billboards::moves);
    }

    @Override
    public int roundLength() {
        return views.size();
    }

    @Override
    public void draw(int frame) {
        draw(frame, StepListener.NONE);
    }

    /** Draws a frame of the round, and calls {@code listener} after each step. */
    void draw(int frame, StepListener listener) {
        if (isAnimated) {
            state.seconds(frame / FRAMES_PER_SECOND);
        }
        renderer.draw(views.get(frame), state, picture, listener);
    }

    @Override
    public void close() {
        renderer.close();
        picture.close();
    }
}
