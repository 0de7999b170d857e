package nephele.app.play;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import nephele.app.play.hud.Area;
import nephele.app.play.hud.Hud;
import nephele.app.play.hud.HudContent;
import nephele.engine.level.Language;
import nephele.engine.level.Level;
import nephele.engine.measure.FrameTimes;
import nephele.engine.measure.Stopwatch;
import nephele.engine.render.Capture;
import nephele.engine.render.Renderer;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.pass.overlay.FontAtlas;
import nephele.engine.render.pass.overlay.OverlayPass;
import nephele.engine.sim.replay.Replay;
import nephele.host.compare.CloudComparison;
import nephele.host.compare.ComparisonFigures;
import nephele.host.compare.TechniquePair;
import nephele.host.compare.Wipe;
import nephele.host.draw.Preparation;
import nephele.host.playthrough.ObserverView;
import nephele.host.playthrough.Playthrough;
import nephele.host.playthrough.ReplayInput;
import nephele.host.terminal.PrintedProgress;

/** Runs `play` without a display: draws the recorded walk offscreen, and saves three pictures and figures. */
public final class OffscreenWalk {
    /**
     * The greatest number of frames. A software rasteriser draws about ten in a second: enough for a look at the walk
     * without a long wait.
     */
    private static final int MOST_FRAMES = 160;

    private static final double[] PICTURES_AT = {0.05, 0.5, 0.95};

    private final PlayRequest request;
    private final PrintStream out;
    private final Path pictures;

    /** @param pictures the folder for three pictures of the walk */
    public OffscreenWalk(PlayRequest request, PrintStream out, Path pictures) {
        this.pictures = pictures;
        this.request = request;
        this.out = out;
    }

    /** Plays the replay to its end. */
    public void run() throws IOException {
        var preparation = preparation();
        try (var gl = GlContext.offscreen();
                var target = target(gl);
                var picture = SessionPicture.load(gl, request, preparation.get(), Optional.empty())) {
            var replay = replay();
            var playthrough = walk(preparation.get(), replay);
            out.println(
                    request.level().typed() + ": " + replay.ticks() + " ticks of a recorded walk, drawn offscreen by "
                            + gl.limits().renderer());
            drawAll(gl, picture, target, playthrough);
            gl.requireNoError("play");
            save(playthrough, preparation.get().opened().level());
        }
    }

    /** Draws only the first frame and reports the time of each part of the start. */
    public void profileStart(StartProfile profile) {
        profile.done("arguments");
        var preparation = preparation();
        try (var gl = GlContext.offscreen();
                var target = target(gl)) {
            profile.done("context");
            var prepared = preparation.get();
            profile.done("waiting for the level");
            try (var picture = SessionPicture.load(gl, request, prepared, Optional.empty())) {
                profile.done("upload and compile");
                var playthrough = walk(prepared, replay());
                draw(picture, target, playthrough);
                gl.finish();
                profile.done("first frame");
                profile.beside("level", prepared.nanos());
                profile.report().forEach(out::println);
            }
        }
    }

    private Preparation preparation() {
        return Preparation.begin(
                request.level(), request.chosenQuality(), PrintedProgress.ofBake(System.err), System.err::println);
    }

    private void drawAll(GlContext gl, SessionPicture picture, RenderTarget target, Playthrough playthrough)
            throws IOException {
        long ticks = Math.max(1, replay().ticks());
        int ticksPerFrame = (int) Math.max(1, (ticks + MOST_FRAMES - 1) / MOST_FRAMES);
        var stopwatch = new Stopwatch();
        var figures = new Figures((int) (ticks / ticksPerFrame) + 1);
        int nextPicture = 0;
        long cpuStartNanos = stopwatch.processCpuNanos();
        for (long tick = 0; tick <= ticks; tick += ticksPerFrame) {
            figures.add(drawOne(gl, picture, target, playthrough), picture.renderer());
            if (nextPicture < PICTURES_AT.length && tick >= PICTURES_AT[nextPicture] * (ticks - ticksPerFrame)) {
                long before = stopwatch.processCpuNanos();
                if (picture.comparison() != null) {
                    reportComparison(gl, picture.comparison(), target);
                }
                savePicture(target, ++nextPicture);
                cpuStartNanos += stopwatch.processCpuNanos() - before;
            }
            for (int i = 0; i < ticksPerFrame && !playthrough.isFinished(); i++) {
                playthrough.tick();
            }
        }
        out.println(figures.text((stopwatch.processCpuNanos() - cpuStartNanos) / 1e6));
    }

    private long drawOne(GlContext gl, SessionPicture picture, RenderTarget target, Playthrough playthrough) {
        long start = System.nanoTime();
        if (playthrough.takeCut()) {
            picture.forget();
        }
        draw(picture, target, playthrough);
        gl.finish();
        return System.nanoTime() - start;
    }

    private void draw(SessionPicture picture, RenderTarget target, Playthrough playthrough) {
        picture.draw(
                playthrough.view(aspect()), playthrough.frameState(), Wipe.MIDDLE, target, Renderer.StepListener.NONE);
    }

    /** Prints the figures of both techniques, and draws the wipe over the picture. */
    private void reportComparison(GlContext gl, CloudComparison comparison, RenderTarget target) {
        ComparisonFigures measured = comparison.measureNow();
        HudContent.Comparison texts = new ComparisonTexts().of(comparison, Wipe.MIDDLE, Language.EN);
        out.println(String.format(
                Locale.ROOT,
                "%s: wall p50 %.1f ms; %s: wall p50 %.1f ms; %s",
                TechniquePair.name(comparison.techniques().left()),
                measured.leftMillis(),
                TechniquePair.name(comparison.techniques().right()),
                measured.rightMillis(),
                texts.difference()));
        var letters = new FontAtlas();
        double pixelsPerPoint = Area.pixelsPerPoint(target.width(), target.height(), 1);
        var area = Area.of(target.width(), target.height(), 1);
        var content = new HudContent(null, HudContent.Page.NONE, List.of(), List.of(), null, null, texts, null, null);
        try (var overlay = new OverlayPass(gl, letters)) {
            overlay.draw(new Hud(letters).canvas(content, area, pixelsPerPoint), target);
        }
    }

    private void savePicture(RenderTarget target, int number) throws IOException {
        var name = request.level().fileName().replaceFirst("\\.json$", "") + "-" + number + ".png";
        Capture.png(target, pictures.resolve(name));
        out.println("picture: " + pictures.resolve(name));
    }

    private void save(Playthrough playthrough, Level level) {
        new Recordings(request.record())
                .keep(() -> playthrough.recorder().replay().recordedIn(level));
    }

    private Replay replay() {
        return request.replay() != null ? request.replay() : request.level().recordedWalk();
    }

    private Playthrough walk(Preparation.Prepared prepared, Replay replay) {
        var from = request.from() != null ? request.from() : replay.start();
        var beginning = new Playthrough.Beginning(request.level().fileName(), replay.settings(), from);
        Level level = prepared.opened().level();
        var playthrough = new Playthrough(level, prepared.world(), beginning, new ReplayInput(replay));
        playthrough.observe(ObserverView.of(level, prepared.scene().statics().models()));
        return playthrough;
    }

    private RenderTarget target(GlContext gl) {
        return RenderTarget.picture(
                gl,
                "picture",
                PixelFormat.RGBA8,
                request.picture().width(),
                request.picture().height());
    }

    private double aspect() {
        return (double) request.picture().width() / request.picture().height();
    }

    /** The costs of the frames. */
    private static final class Figures {
        private final long[] wallNanos;
        private int frames;
        private long draws;
        private long triangles;

        Figures(int most) {
            wallNanos = new long[most];
        }

        void add(long nanos, Renderer renderer) {
            wallNanos[frames++] = nanos;
            draws += renderer.draws();
            triangles += renderer.triangles();
        }

        String text(double cpuMs) {
            return String.format(
                    Locale.ROOT,
                    "frames %d, CPU %.1f ms a frame, wall p50 %.1f ms, p95 %.1f ms, draws %.1f, triangles %.0f",
                    frames,
                    cpuMs / frames,
                    FrameTimes.percentileMs(wallNanos, frames, 0.5),
                    FrameTimes.percentileMs(wallNanos, frames, 0.95),
                    (double) draws / frames,
                    (double) triangles / frames);
        }
    }
}
