package nephele.workshop.prove.process;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.measure.Stopwatch;
import nephele.engine.render.Renderer;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.host.playthrough.Playthrough;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Runs the game's frames without a window and counts their allocations. */
final class Soak {
    private static final double LONGEST_PAUSE_MS = 5;
    private static final double MOST_BYTES_A_FRAME = 2048;
    private static final double MOST_BYTES_A_TICK = 4096;
    private static final long NANOS_PER_SECOND = 1_000_000_000L;

    /** Creates a walk from the beginning. */
    @FunctionalInterface
    interface Beginner {
        Playthrough begin();
    }

    private final GlContext gl;
    private final Renderer renderer;
    private final RenderTarget picture;
    private final Beginner beginner;
    private final Stopwatch stopwatch = new Stopwatch();
    private Playthrough playthrough;
    private long frames;
    private long ticks;
    private long bytesOfFrames;
    private long bytesOfTicks;
    private boolean finite = true;

    Soak(GlContext gl, Renderer renderer, RenderTarget picture, Beginner beginner) {
        this.gl = gl;
        this.renderer = renderer;
        this.picture = picture;
        this.beginner = beginner;
        playthrough = beginner.begin();
    }

    void forget() {
        frames = 0;
        ticks = 0;
        bytesOfFrames = 0;
        bytesOfTicks = 0;
    }

    void play(long seconds, Proof.Progress progress) {
        long start = System.nanoTime();
        long last = start;
        while (last - start < seconds * NANOS_PER_SECOND) {
            long now = System.nanoTime();
            simulate(now - last);
            draw();
            last = now;
            progress.unitsDone((now - start) / NANOS_PER_SECOND);
        }
    }

    private void simulate(long elapsedNanos) {
        long tickBefore = playthrough.state().tick();
        long before = stopwatch.allocatedBytes();
        playthrough.advance(elapsedNanos);
        bytesOfTicks += stopwatch.allocatedBytes() - before;
        ticks += playthrough.state().tick() - tickBefore;
        finite &= playthrough.state().faults() == 0;
        if (playthrough.isFinished()) {
            playthrough = beginner.begin();
        }
    }

    private void draw() {
        long before = stopwatch.allocatedBytes();
        renderer.draw(playthrough.view((double) picture.width() / picture.height()), playthrough.frameState(), picture);
        bytesOfFrames += stopwatch.allocatedBytes() - before;
        gl.finish();
        frames++;
    }

    ProofResult result(long seconds, CollectorPauses pauses) {
        double bytesAFrame = (double) bytesOfFrames / Math.max(1, frames);
        double bytesATick = (double) bytesOfTicks / Math.max(1, ticks);
        var failures = new ArrayList<String>();
        check(failures, "GC pause of %.1f ms", pauses.longestMs(), LONGEST_PAUSE_MS);
        check(failures, "%.0f bytes a frame", bytesAFrame, MOST_BYTES_A_FRAME);
        check(failures, "%.0f bytes a tick", bytesATick, MOST_BYTES_A_TICK);
        if (!finite) {
            failures.add("the simulation undid a tick that was not finite");
        }
        gl.requireNoError("soak");
        return ProofResult.of(
                seconds,
                failures,
                Figure.greatest("longest GC pause", pauses.longestMs(), "ms"),
                Figure.sum("collections", pauses.count(), ""),
                Figure.greatest("render path", bytesAFrame, "B a frame"),
                Figure.greatest("simulation", bytesATick, "B a tick"),
                Figure.sum("frames", frames, ""));
    }

    private static void check(List<String> failures, String text, double value, double most) {
        if (value > most) {
            failures.add(String.format(Locale.ROOT, text, value));
        }
    }
}
