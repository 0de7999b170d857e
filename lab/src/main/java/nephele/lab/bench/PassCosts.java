package nephele.lab.bench;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import nephele.engine.measure.Stopwatch;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.timing.StepTimer;

/**
 * The mean cost of each pass of a frame. In software each pass is drawn to its end before the next begins, so that the
 * sum is a little more than a frame that is drawn at once.
 *
 * @param clock the name of the clock
 * @param ms by pass, in the order of the frame
 */
public record PassCosts(String clock, Map<String, Double> ms) {
    /** Process CPU of what is measured. The clock advances in steps of 10 ms; a pass is known to some 2 % of the frame. */
    private static final double SECONDS = 3;

    private static final int LEAST_FRAMES = 20;

    private static final int WARM_UP_FRAMES = 4;

    /** Passes below this part of the frame are left out of a row. */
    private static final double LEAST_SHARE = 0.02;

    /** The titles of the columns of {@link #row}, in Markdown. */
    public static final String TABLE_HEADER = "| level | camera | quality | ms | passes |\n|---|---|---|---|---|";

    /** Measures frames of the drawing's path. */
    public static PassCosts of(GlContext gl, LevelDrawing drawing) {
        var names = drawing.renderer().stepNames();
        var ms = new LinkedHashMap<String, Double>();
        var stopwatch = new Stopwatch();
        var cpu = new StepTimer.Clock("process CPU time to glFinish", stopwatch::processCpuNanos);
        try (var timer = StepTimer.of(gl, cpu, names.size())) {
            for (int frame = 0; frame < WARM_UP_FRAMES; frame++) {
                draw(drawing, frame, timer);
            }
            timer.reset();
            long start = stopwatch.processCpuNanos();
            int least = Math.max(LEAST_FRAMES, drawing.roundLength()) * timer.framesOfARound();
            for (int frame = 0; frame < least || stopwatch.processCpuNanos() - start < SECONDS * 1e9; frame++) {
                draw(drawing, frame, timer);
            }
            for (int step = 0; step < names.size(); step++) {
                ms.merge(names.get(step), timer.meanMs(step), Double::sum);
            }
            return new PassCosts(timer.clock(), ms);
        }
    }

    private static void draw(LevelDrawing drawing, int frame, StepTimer timer) {
        timer.frameBegins();
        drawing.draw(frame % drawing.roundLength(), timer);
    }

    /** Returns CSV lines: a header that names the clock, then one line a pass. */
    public List<String> csv() {
        var lines = new ArrayList<String>();
        lines.add("pass,msMean (" + clock + ")");
        ms.forEach((pass, mean) -> lines.add(String.format(Locale.ROOT, "%s,%.3f", pass, mean)));
        return lines;
    }

    /**
     * Returns a row of a table in Markdown with the dearest passes, dearest first.
     *
     * @param level the first columns, {@code camera} and {@code quality} likewise
     * @param scale multiplies each figure
     */
    public String row(String level, String camera, String quality, double scale) {
        double sum = ms.values().stream().mapToDouble(Double::doubleValue).sum();
        var dearest = ms.entrySet().stream()
                .filter(pass -> pass.getValue() >= LEAST_SHARE * sum)
                .sorted(Map.Entry.<String, Double>comparingByValue().reversed())
                .map(pass -> String.format(Locale.ROOT, "%s %.1f", pass.getKey(), scale * pass.getValue()))
                .collect(Collectors.joining(", "));
        return String.format(Locale.ROOT, "| %s | %s | %s | %.1f | %s |", level, camera, quality, scale * sum, dearest);
    }
}
