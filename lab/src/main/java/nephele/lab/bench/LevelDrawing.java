package nephele.lab.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.level.Billboards;
import nephele.engine.level.Level;
import nephele.engine.render.Renderer;
import nephele.engine.render.Renderer.StepListener;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.timing.StepTimer;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.View;

/** A level drawn by the engine along a camera path; particles and billboards move by 1/60 s in each frame of it. */
public record LevelDrawing(
        Renderer renderer, List<View> views, RenderTarget picture, FrameState state, boolean isAnimated)
        implements Drawing {
    private static final double FRAMES_PER_SECOND = 60;
    private static final int LEAST_TIMED_FRAMES = 60;

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

    private void draw(int frame, StepListener listener) {
        if (isAnimated) {
            state.seconds(frame / FRAMES_PER_SECOND);
        }
        renderer.draw(views.get(frame), state, picture, listener);
    }

    /** Measures each pass of a frame. Returns CSV lines: a header that names the clock, then one line a pass. */
    public List<String> passTimes(GlContext gl) {
        var names = renderer.stepNames();
        var lines = new ArrayList<String>();
        try (var timer = StepTimer.of(gl, names.size())) {
            int frames = Math.max(LEAST_TIMED_FRAMES, roundLength()) * names.size();
            for (int frame = 0; frame < frames; frame++) {
                timer.frameBegins();
                draw(frame % roundLength(), timer);
            }
            lines.add("pass,msMean (" + timer.clock() + ")");
            for (int step = 0; step < names.size(); step++) {
                lines.add(String.format(Locale.ROOT, "%s,%.3f", names.get(step), timer.meanMs(step)));
            }
        }
        return lines;
    }

    @Override
    public void close() {
        renderer.close();
        picture.close();
    }
}
