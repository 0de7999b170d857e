package nephele.app.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.render.Renderer.StepListener;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GpuTimer;

/**
 * How long each pass of a frame takes: with a timer query a pass on hardware, with {@code glFinish} after each pass
 * where OpenGL runs in software, because its timer queries are wrong there.
 */
public final class PerPass {
    private static final int LEAST_FRAMES = 60;

    private final GlContext gl;
    private final LevelDrawing drawing;

    public PerPass(GlContext gl, LevelDrawing drawing) {
        this.gl = gl;
        this.drawing = drawing;
    }

    /** A header that says which clock it was, then a line a pass. */
    public List<String> csv() {
        boolean software = gl.limits().software();
        int frames = Math.max(LEAST_FRAMES, drawing.roundLength());
        double[] ms = software ? finished(frames) : queried(frames);
        var lines = new ArrayList<String>();
        lines.add(software ? "pass,wallMsMeanToGlFinish" : "pass,gpuMsMean");
        var names = drawing.stepNames();
        for (int step = 0; step < names.size(); step++) {
            lines.add(String.format(Locale.ROOT, "%s,%.3f", names.get(step), ms[step] / frames));
        }
        return lines;
    }

    private double[] finished(int frames) {
        var clock = new FinishClock(gl, drawing.stepNames().size());
        for (int frame = 0; frame < frames; frame++) {
            clock.start();
            drawing.draw(frame % drawing.roundLength(), clock);
        }
        return clock.ms;
    }

    private double[] queried(int frames) {
        int steps = drawing.stepNames().size();
        double[] ms = new double[steps];
        try (var timer = new GpuTimer(gl, "a pass")) {
            for (int timed = 0; timed < steps; timed++) {
                for (int frame = 0; frame < frames; frame++) {
                    var listener = new OneStep(timer, timed);
                    listener.frameBegins();
                    drawing.draw(frame % drawing.roundLength(), listener);
                    ms[timed] += timer.nanoseconds() / 1e6;
                }
            }
        }
        return ms;
    }

    /** Queries can't be nested and belong to one frame: one pass is timed a frame. */
    private record OneStep(GpuTimer timer, int timed) implements StepListener {
        void frameBegins() {
            if (timed == 0) {
                timer.start();
            }
        }

        @Override
        public void submitted(int step) {
            if (step == timed) {
                timer.stop();
            } else if (step == timed - 1) {
                timer.start();
            }
        }
    }

    /** Waits for each pass to be drawn before the next one begins. */
    private static final class FinishClock implements StepListener {
        private final GlContext gl;
        private final double[] ms;
        private long last;

        FinishClock(GlContext gl, int steps) {
            this.gl = gl;
            ms = new double[steps];
        }

        void start() {
            gl.finish();
            last = System.nanoTime();
        }

        @Override
        public void submitted(int step) {
            gl.finish();
            long now = System.nanoTime();
            ms[step] += (now - last) / 1e6;
            last = now;
        }
    }
}
