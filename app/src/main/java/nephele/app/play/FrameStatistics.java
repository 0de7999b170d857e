package nephele.app.play;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.app.play.hud.HudContent.Figure;
import nephele.app.settings.Phrase;
import nephele.engine.level.Language;
import nephele.engine.measure.Stopwatch;
import nephele.engine.render.Renderer;
import nephele.engine.render.Renderer.StepListener;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.timing.StepTimer;
import nephele.host.playthrough.Playthrough;

/**
 * The figures of the F3 panel, averaged over a quarter of a second so that they are readable; nothing is timed while the panel is
 * closed.
 */
final class FrameStatistics implements AutoCloseable {
    private static final long INTERVAL_NANOS = 250_000_000L;

    private final GlContext gl;
    private final Stopwatch stopwatch = new Stopwatch();
    private List<Figure> figures = List.of();
    private long intervalStart;
    private long allocatedAtStart;
    private int frames;

    /** The timed renderer; {@code null} while the panel is closed, as the timer is. */
    private Renderer renderer;

    private StepTimer timer;

    FrameStatistics(GlContext gl) {
        this.gl = gl;
    }

    /** Opens the panel for a renderer, or closes it. */
    void toggle(Renderer timed) {
        boolean closes = isOpen();
        close();
        if (!closes) {
            renderer = timed;
            timer = StepTimer.of(gl, StepTimer.Clock.WALL, timed.stepNames().size());
            beginInterval(System.nanoTime());
        }
    }

    boolean isOpen() {
        return renderer != null;
    }

    /** Returns the lines for the last frames; empty if the panel is closed. */
    List<Figure> lines() {
        return figures;
    }

    /** Starts to time a frame, if the panel is open. */
    StepListener frameBegins() {
        if (!isOpen()) {
            return StepListener.NONE;
        }
        timer.frameBegins();
        return timer;
    }

    /** @param language of the lines */
    void frameEnds(Playthrough playthrough, Language language) {
        if (!isOpen()) {
            return;
        }
        frames++;
        long now = System.nanoTime();
        if (now - intervalStart >= INTERVAL_NANOS) {
            figures = read(now, playthrough, language);
            timer.reset();
            beginInterval(now);
        }
    }

    private void beginInterval(long now) {
        frames = 0;
        allocatedAtStart = stopwatch.allocatedBytes();
        intervalStart = now;
    }

    private List<Figure> read(long now, Playthrough playthrough, Language language) {
        double frameMs = (now - intervalStart) / 1e6 / frames;
        long allocated = (stopwatch.allocatedBytes() - allocatedAtStart) / frames;
        var lines = new ArrayList<Figure>();
        lines.add(new Figure(Phrase.FIGURE_FRAMES.in(language), String.format(Locale.ROOT, "%.1f", 1000 / frameMs)));
        lines.add(new Figure(Phrase.FIGURE_FRAME.in(language), ms(frameMs)));
        List<String> stepNames = renderer.stepNames();
        for (int step = 0; step < stepNames.size(); step++) {
            lines.add(new Figure("  " + Phrase.ofStep(stepNames.get(step)).in(language), ms(timer.meanMs(step))));
        }
        lines.add(new Figure(Phrase.FIGURE_DRAWS.in(language), Long.toString(renderer.draws())));
        lines.add(new Figure(Phrase.FIGURE_TRIANGLES.in(language), Long.toString(renderer.triangles())));
        lines.add(new Figure(Phrase.FIGURE_ALLOCATED.in(language), allocated + " B"));
        lines.add(new Figure(
                Phrase.FIGURE_TICK.in(language),
                Long.toString(playthrough.state().tick())));
        return List.copyOf(lines);
    }

    private static String ms(double ms) {
        return String.format(Locale.ROOT, "%.2f ms", ms);
    }

    @Override
    public void close() {
        if (isOpen()) {
            timer.close();
            timer = null;
            renderer = null;
            figures = List.of();
        }
    }
}
