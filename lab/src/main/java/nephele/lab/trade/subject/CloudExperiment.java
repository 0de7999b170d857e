package nephele.lab.trade.subject;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.measure.Flip;
import nephele.engine.measure.ImageError;
import nephele.engine.measure.LinearPicture;
import nephele.engine.render.frame.Quality;
import nephele.lab.trade.Experiment;
import nephele.lab.trade.Judgement;
import nephele.lab.trade.TradeSite;

/**
 * Ways to draw clouds. A still picture is compared with the reference picture's; frames while the view turns with those of all rays at
 * the finest steps, whose light is that of the setting itself: what stays wrong does not flicker.
 */
final class CloudExperiment implements Experiment {
    static final List<String> FIGURES = List.of(
            "mean bias %",
            "HDR-FLIP, 99th percentile",
            "transmittance RMSE",
            "density evaluations a pixel",
            "cloud textures, MiB",
            "flicker",
            "ghost: FLIP of the 2nd frame");

    private static final int BIAS = 1;
    private static final int QUANTILE = 2;
    private static final double MEBIBYTE = 1 << 20;

    private final TradeSite site;
    private final PictureExperiment pictures;
    private final Judged judged;
    private final Footage path;
    private CloudRays rays;

    /** The picture by which a setting is judged. */
    enum Judged {
        /** One of a still view. */
        STILL,
        /** The last one of a view that turns. */
        TURNING,
        /** The worst one of an eye that moves. */
        FLYING
    }

    CloudExperiment(TradeSite site, List<PictureSetting> settings, Judged judged) {
        this.site = site;
        this.judged = judged;
        pictures = new PictureExperiment(site, settings, ComparedValues.RADIANCE);
        path = judged == Judged.FLYING ? Footage.flight(site) : Footage.path(site);
    }

    @Override
    public Judgement judge(int setting) {
        Shot shot = pictures.shot(setting);
        Judgement still = pictures.judge(setting);
        List<LinearPicture> wanted = frames(finest(shot));
        List<LinearPicture> test = frames(shot);
        int last = test.size() - 1;
        List<Double> figures = new ArrayList<>();
        figures.add(still.figures().get(BIAS));
        figures.add(still.figures().get(QUANTILE));
        addMarched(figures, shot);
        figures.add(textures(shot) / MEBIBYTE);
        figures.add(ImageError.shimmer(wanted, test));
        figures.add(Flip.ofDisplayed(wanted.get(1), test.get(1)).mean());
        double error =
                switch (judged) {
                    case STILL -> still.error();
                    case TURNING ->
                        Flip.ofDisplayed(wanted.get(last), test.get(last)).mean();
                    case FLYING -> worst(wanted, test);
                };
        return new Judgement(error, List.copyOf(figures), still.picture(), still.map());
    }

    private static double worst(List<LinearPicture> wanted, List<LinearPicture> test) {
        return IntStream.range(0, test.size())
                .mapToDouble(i -> Flip.ofDisplayed(wanted.get(i), test.get(i)).mean())
                .max()
                .orElseThrow();
    }

    private static Shot finest(Shot shot) {
        return shot.set("cloudHistory", "none")
                .set("cloudResolution", 1)
                .set("cloudStep", 0.25)
                .set("impostors", "off");
    }

    private List<LinearPicture> frames(Shot shot) {
        try (var renderer = pictures.renderer(shot)) {
            return path.displayed(site.gl(), renderer, 1);
        }
    }

    private void addMarched(List<Double> figures, Shot shot) {
        if (rays == null) {
            rays = new CloudRays(site.placed(), site.view());
        }
        Quality quality = shot.settings(site.gl().limits().software()).quality();
        rays.march(quality.cloudStep());
        double fraction = quality.cloudResolution() / quality.cloudHistory().side();
        figures.add(rays.transmittanceError());
        figures.add(fraction * fraction * rays.evaluations());
    }

    /** Returns the bytes of textures that a renderer has less if the level has no clouds. */
    private double textures(Shot shot) {
        Level level = shot.level();
        Environment env = level.environment();
        var clear = new Environment(
                env.sun(), env.sky(), env.ambient(), env.exposureStops(), env.toneCurve(), env.fog(), List.of());
        return bytes(shot) - bytes(shot.with(level.with(clear, level.lights())));
    }

    private long bytes(Shot shot) {
        long before = site.gl().live().textureBytes();
        try (var renderer = pictures.renderer(shot)) {
            pictures.draw(renderer);
            return site.gl().live().textureBytes() - before;
        }
    }

    @Override
    public BufferedImage exact() {
        return pictures.exact();
    }

    @Override
    public void run(int setting) {
        pictures.run(setting);
    }

    @Override
    public void close() {
        pictures.close();
        if (rays != null) {
            rays.close();
        }
    }
}
