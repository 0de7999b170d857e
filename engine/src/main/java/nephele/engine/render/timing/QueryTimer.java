package nephele.engine.render.timing;

import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GpuTimer;

/** Times one step of each frame in turn with GPU queries, because queries cannot be nested. */
final class QueryTimer implements StepTimer {
    private final GpuTimer timer;
    private final StepMeans means;
    private int timed = -1;
    private boolean answerWaits;

    QueryTimer(GlContext gl, int steps) {
        timer = new GpuTimer(gl, "a step of a frame");
        means = new StepMeans(steps);
    }

    @Override
    public void frameBegins() {
        if (answerWaits) {
            means.add(timed, timer.nanoseconds());
            answerWaits = false;
        }
        timed = (timed + 1) % means.steps();
        if (timed == 0) {
            timer.start();
        }
    }

    @Override
    public void submitted(int step) {
        if (step == timed) {
            timer.stop();
            answerWaits = true;
        } else if (step == timed - 1) {
            timer.start();
        }
    }

    @Override
    public double meanMs(int step) {
        return means.meanMs(step);
    }

    @Override
    public void reset() {
        means.reset();
    }

    @Override
    public String clock() {
        return "GPU time";
    }

    @Override
    public void close() {
        timer.close();
    }
}
