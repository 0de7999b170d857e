package nephele.lab.trade.subject;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.measure.ErrorMap;
import nephele.engine.measure.ImageError;
import nephele.engine.measure.LinearPicture;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.resource.PictureHistory;
import nephele.engine.scene.Scene;
import nephele.host.draw.QualityChoice;
import nephele.lab.trade.Experiment;
import nephele.lab.trade.Judgement;
import nephele.lab.trade.TradeSite;

/** One renderer for each setting, drawing the same view in turn. */
final class PictureExperiment implements Experiment {
    /** A technique that reuses previous pictures is judged after so many frames. */
    static final int SETTLING_FRAMES = PictureHistory.POINTS;

    private final TradeSite site;
    private final ComparedValues compared;
    private final Shot usual;
    private final List<Shot> shots = new ArrayList<>();
    private final List<Renderer> renderers = new ArrayList<>();
    private final Map<Level, Scene> scenes = new HashMap<>();
    private final RenderTarget picture;
    private LinearPicture exact;

    PictureExperiment(TradeSite site, List<PictureSetting> settings, ComparedValues compared) {
        this.site = site;
        this.compared = compared;
        usual = Shot.high(site.level(), QualityChoice.defaultOutput(site.level()));
        settings.forEach(setting -> shots.add(setting.change().apply(usual)));
        picture = RenderTarget.picture(
                site.gl(),
                "trade",
                PixelFormat.RGBA8,
                site.extent().width(),
                site.extent().height());
        settings.forEach(setting -> renderers.add(null));
    }

    /** Returns the shot that a setting is timed with. */
    Shot shot(int setting) {
        return shots.get(setting);
    }

    @Override
    public Judgement judge(int setting) {
        return judged(compared.read(drawn(compared.judged(shots.get(setting))), picture));
    }

    /** Draws a settled frame into the picture, and returns its radiance if the shot's output is HDR. */
    private float[] drawn(Shot shot) {
        try (var renderer = renderer(shot)) {
            for (int frame = 0; frame < SETTLING_FRAMES; frame++) {
                renderer.draw(site.view(), picture);
            }
            site.gl().requireNoError("trade");
            return shot.output() == Output.HDR ? renderer.readRadiance() : null;
        }
    }

    private Judgement judged(LinearPicture test) {
        var shown = compared.shown(test, site.level().environment());
        return judgement(reference(), test, compared.flip(reference(), test), shown);
    }

    static Judgement judgement(LinearPicture exact, LinearPicture test, ErrorMap flip, BufferedImage shown) {
        double squared = ImageError.relativeSquared(exact, test);
        double bias = 100 * ImageError.meanBias(exact, test);
        return new Judgement(flip.mean(), List.of(squared, bias, flip.quantile(0.99)), shown, flip);
    }

    private LinearPicture reference() {
        if (exact == null) {
            exact = compared.exact(this::radiance, site);
        }
        return exact;
    }

    /** Returns the radiance of the usual picture. */
    private LinearPicture radiance() {
        return new LinearPicture(picture.width(), picture.height(), drawn(usual.with(Output.HDR)));
    }

    @Override
    public BufferedImage exact() {
        return compared.shown(reference(), site.level().environment());
    }

    @Override
    public void run(int setting) {
        if (renderers.get(setting) == null) {
            renderers.set(setting, renderer(shots.get(setting)));
        }
        draw(renderers.get(setting));
    }

    void draw(Renderer renderer) {
        renderer.draw(site.view(), picture);
        site.gl().finish();
    }

    Renderer renderer(Shot shot) {
        Scene scene = scenes.computeIfAbsent(shot.level(), site::scene);
        return LevelRenderer.load(
                site.gl(), scene, shot.settings(site.gl().limits().software()));
    }

    @Override
    public void close() {
        renderers.stream().filter(renderer -> renderer != null).forEach(Renderer::close);
        picture.close();
    }
}
