package nephele.app.play;

import java.util.List;
import nephele.app.play.hud.HudContent;
import nephele.engine.level.Language;
import nephele.engine.render.Renderer;
import nephele.engine.render.Renderer.StepListener;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.timing.StepTimer;
import nephele.host.playthrough.Playthrough;

/** The F3 panel; nothing is timed while it is closed. */
final class FrameStatisticsControl implements AutoCloseable {
    private final GlContext gl;

    private FrameStatistics figures;
    private List<HudContent.Figure> lines = List.of();

    FrameStatisticsControl(GlContext gl) {
        this.gl = gl;
    }

    /** Opens the panel for {@code renderer}, or closes it. */
    void toggle(Renderer renderer) {
        boolean closes = figures != null;
        close();
        if (!closes) {
            figures = new FrameStatistics(
                    renderer, StepTimer.of(gl, renderer.stepNames().size()));
        }
    }

    boolean isOpen() {
        return figures != null;
    }

    /** Returns the lines for the last frames; empty if the panel is closed. */
    List<HudContent.Figure> lines() {
        return lines;
    }

    /** Starts to time a frame, if the panel is open. */
    StepListener frameBegins() {
        if (figures == null) {
            return StepListener.NONE;
        }
        figures.timer().frameBegins();
        return figures.timer();
    }

    /** @param language of the lines */
    void frameEnds(Playthrough playthrough, Language language) {
        if (figures != null) {
            lines = figures.afterFrame(playthrough, language);
        }
    }

    @Override
    public void close() {
        if (figures != null) {
            figures.close();
            figures = null;
            lines = List.of();
        }
    }
}
