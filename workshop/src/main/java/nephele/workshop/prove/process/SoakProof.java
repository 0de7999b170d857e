package nephele.workshop.prove.process;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Supplier;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.measure.Stopwatch;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.host.draw.Preparation;
import nephele.host.draw.QualityChoice;
import nephele.host.named.LevelCatalogue;
import nephele.host.named.LevelName;
import nephele.host.playthrough.Playthrough;
import nephele.host.playthrough.ReplayInput;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Plays level 01 offscreen in real time, repeatedly, and measures garbage collection pauses and allocations. */
public final class SoakProof implements Proof {
    private static final QualityChoice QUALITY = new QualityChoice("high", Map.of());
    private static final int WARM_UP_SECONDS = 3;
    private static final double LONGEST_PAUSE_MS = 5;
    private static final double MOST_BYTES_A_FRAME = 2048;
    private static final double MOST_BYTES_A_TICK = 4096;
    private static final long NANOS_PER_SECOND = 1_000_000_000L;

    private final int width;
    private final int height;

    /** Uses the size with which the game starts. */
    public SoakProof() {
        this(1280, 720);
    }

    SoakProof(int width, int height) {
        this.width = width;
        this.height = height;
    }

    @Override
    public Claim claim() {
        return new Claim(
                "soak",
                "ten minutes of level 01: no GC pause over 5 ms, at most 2 KiB a frame and 4 KiB a tick",
                "seconds",
                600,
                120);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        var level = LevelCatalogue.first();
        var prepared =
                Preparation.begin(level, QUALITY, fraction -> {}, warning -> {}).get();
        var settings = RenderSettings.of(QUALITY.output(prepared.opened().level()));
        try (var gl = GlContext.offscreen();
                var picture = RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, width, height);
                var renderer = LevelRenderer.load(gl, prepared.scene(), settings)) {
            var run = new Run(gl, renderer, picture, () -> walk(level, prepared));
            run.play(WARM_UP_SECONDS, Progress.NONE);
            run.forget();
            try (var pauses = CollectorPauses.listen()) {
                run.play(count, progress);
                return run.result(count, pauses);
            }
        }
    }

    private static Playthrough walk(LevelName level, Preparation.Prepared prepared) {
        var replay = level.recordedWalk();
        var beginning = new Playthrough.Beginning(level.fileName(), replay.settings(), replay.start());
        return new Playthrough(prepared.opened().level(), prepared.world(), beginning, new ReplayInput(replay));
    }

    /** Frames of the game without a window, with the bytes that they allocate. */
    private static final class Run {
        private final GlContext gl;
        private final Renderer renderer;
        private final RenderTarget picture;
        /** Creates a walk from the beginning. */
        private final Supplier<Playthrough> walks;

        private final Stopwatch stopwatch = new Stopwatch();
        private Playthrough playthrough;
        private long frames;
        private long ticks;
        private long bytesOfFrames;
        private long bytesOfTicks;
        private boolean finite = true;

        Run(GlContext gl, Renderer renderer, RenderTarget picture, Supplier<Playthrough> walks) {
            this.gl = gl;
            this.renderer = renderer;
            this.picture = picture;
            this.walks = walks;
            playthrough = walks.get();
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
                playthrough = walks.get();
            }
        }

        private void draw() {
            long before = stopwatch.allocatedBytes();
            renderer.draw(
                    playthrough.view((double) picture.width() / picture.height()), playthrough.frameState(), picture);
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
}
