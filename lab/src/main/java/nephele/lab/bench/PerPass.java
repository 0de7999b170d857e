package nephele.lab.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.timing.StepTimer;

/** Measures the time of each pass of a frame. */
public final class PerPass {
    private static final int LEAST_FRAMES = 60;

    private final GlContext gl;
    private final LevelDrawing drawing;

    public PerPass(GlContext gl, LevelDrawing drawing) {
        this.gl = gl;
        this.drawing = drawing;
    }

    /** Returns CSV lines: a header that names the clock, then one line a pass. */
    public List<String> csv() {
        var names = drawing.renderer().stepNames();
        var lines = new ArrayList<String>();
        try (var timer = StepTimer.of(gl, names.size())) {
            int frames = Math.max(LEAST_FRAMES, drawing.roundLength()) * names.size();
            for (int frame = 0; frame < frames; frame++) {
                timer.frameBegins();
                drawing.draw(frame % drawing.roundLength(), timer);
            }
            lines.add("pass,msMean (" + timer.clock() + ")");
            for (int step = 0; step < names.size(); step++) {
                lines.add(String.format(Locale.ROOT, "%s,%.3f", names.get(step), timer.meanMs(step)));
            }
        }
        return lines;
    }
}
