package nephele.engine.render.timing;

import nephele.engine.render.gl.GlContext;

/** Times each step by waiting for its completion before the next one begins. */
final class FinishTimer implements StepTimer {
    private final GlContext gl;
    private final StepMeans means;
    private long lastNanos;

    FinishTimer(GlContext gl, int steps) {
        this.gl = gl;
        means = new StepMeans(steps);
    }

    @Override
    public void frameBegins() {
        gl.finish();
        lastNanos = System.nanoTime();
    }

    @Override
    public void submitted(int step) {
        gl.finish();
        long now = System.nanoTime();
        means.add(step, now - lastNanos);
        lastNanos = now;
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
        return "wall time to glFinish";
    }

    @Override
    public void close() {
        reset();
    }
}
