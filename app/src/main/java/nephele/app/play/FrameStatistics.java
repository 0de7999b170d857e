package nephele.app.play;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.app.play.hud.HudContent.Figure;
import nephele.app.settings.Phrase;
import nephele.engine.level.Language;
import nephele.engine.measure.Stopwatch;
import nephele.engine.render.Renderer;
import nephele.engine.render.timing.StepTimer;
import nephele.host.playthrough.Playthrough;

/** The figures of the F3 panel, averaged over a quarter of a second so that they are readable. */
final class FrameStatistics implements AutoCloseable {
    private static final long INTERVAL_NANOS = 250_000_000L;

    private final Renderer renderer;
    private final List<String> stepNames;
    private final StepTimer timer;
    private final Stopwatch stopwatch = new Stopwatch();
    private List<Figure> figures = List.of();
    private long intervalStart = System.nanoTime();
    private long allocatedAtStart = stopwatch.allocatedBytes();
    private int frames;

    FrameStatistics(Renderer renderer, StepTimer timer) {
        this.renderer = renderer;
        this.timer = timer;
        stepNames = renderer.stepNames();
    }

    /** Returns the listener for the steps of the frames. */
    StepTimer timer() {
        return timer;
    }

    /** Returns the panel's lines; called after each frame. */
    List<Figure> afterFrame(Playthrough playthrough, Language language) {
        frames++;
        long now = System.nanoTime();
        if (now - intervalStart >= INTERVAL_NANOS) {
            figures = read(now, playthrough, language);
            timer.reset();
            frames = 0;
            allocatedAtStart = stopwatch.allocatedBytes();
            intervalStart = now;
        }
        return figures;
    }

    private List<Figure> read(long now, Playthrough playthrough, Language language) {
        double frameMs = (now - intervalStart) / 1e6 / frames;
        long allocated = (stopwatch.allocatedBytes() - allocatedAtStart) / frames;
        var lines = new ArrayList<Figure>();
        lines.add(new Figure(Phrase.FIGURE_FRAMES.in(language), String.format(Locale.ROOT, "%.1f", 1000 / frameMs)));
        lines.add(new Figure(Phrase.FIGURE_FRAME.in(language), ms(frameMs)));
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
        timer.close();
    }
}
