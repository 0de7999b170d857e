package nephele.workshop.prove.process;

import java.util.Map;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.render.RenderSettings;
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
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Plays level 01 offscreen in real time, repeatedly, and measures garbage collection pauses and allocations. */
public final class SoakProof implements Proof {
    private static final QualityChoice QUALITY = new QualityChoice("high", Map.of());
    private static final int WARM_UP_SECONDS = 3;

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
        var prepared = Preparation.begin(level, QUALITY, fraction -> {}).get();
        var settings = RenderSettings.of(QUALITY.output(prepared.opened().level()));
        try (var gl = GlContext.offscreen();
                var picture = RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, width, height);
                var renderer = LevelRenderer.load(gl, prepared.scene(), settings)) {
            var soak = new Soak(gl, renderer, picture, () -> walk(level, prepared));
            soak.play(WARM_UP_SECONDS, Progress.NONE);
            soak.forget();
            try (var pauses = CollectorPauses.listen()) {
                soak.play(count, progress);
                return soak.result(count, pauses);
            }
        }
    }

    private static Playthrough walk(LevelName level, Preparation.Prepared prepared) {
        var replay = level.recordedWalk();
        var beginning = new Playthrough.Beginning(level.fileName(), replay.settings(), replay.start());
        return new Playthrough(prepared.opened().level(), prepared.world(), beginning, new ReplayInput(replay));
    }
}
