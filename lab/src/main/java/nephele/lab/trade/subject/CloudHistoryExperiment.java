package nephele.lab.trade.subject;

import java.awt.image.BufferedImage;
import java.util.List;
import nephele.engine.measure.ErrorMap;
import nephele.engine.measure.Flip;
import nephele.engine.measure.LinearPicture;
import nephele.engine.measure.Shimmer;
import nephele.lab.trade.Experiment;
import nephele.lab.trade.Judgement;
import nephele.lab.trade.TradeSite;

/**
 * Ways to divide the rays through clouds among frames, compared with frames of all rays while the view turns: a still
 * picture is the same with each of them.
 */
final class CloudHistoryExperiment implements Experiment {
    static final List<String> FIGURES = List.of("flicker", "ghost: FLIP of the 2nd frame", "FLIP, 99th percentile");

    private final TradeSite site;
    private final PictureExperiment pictures;
    private final Footage path;
    private List<LinearPicture> exact;

    CloudHistoryExperiment(TradeSite site, List<PictureSetting> settings) {
        this.site = site;
        pictures = new PictureExperiment(site, settings, Compared.DISPLAY);
        path = Footage.path(site);
    }

    @Override
    public Judgement judge(int setting) {
        List<LinearPicture> wanted = reference();
        List<LinearPicture> test = drawn(pictures.shot(setting));
        int last = test.size() - 1;
        ErrorMap flip = Flip.ofDisplayed(wanted.get(last), test.get(last));
        List<Double> figures = List.of(
                Shimmer.of(wanted, test),
                Flip.ofDisplayed(wanted.get(1), test.get(1)).mean(),
                flip.quantile(0.99));
        return new Judgement(flip.mean(), figures, shown(test.get(last)), flip);
    }

    private List<LinearPicture> drawn(Shot shot) {
        try (var renderer = pictures.renderer(shot)) {
            return path.displayed(site.gl(), renderer, 1);
        }
    }

    /** Returns the frames of all rays; drawn at the first call, because all settings share them. */
    private List<LinearPicture> reference() {
        if (exact == null) {
            exact = drawn(pictures.shot(0).set("cloudHistory", "none"));
        }
        return exact;
    }

    @Override
    public BufferedImage exact() {
        return shown(reference().get(path.views().size() - 1));
    }

    private BufferedImage shown(LinearPicture picture) {
        return Compared.DISPLAY.shown(picture, site.level().environment());
    }

    @Override
    public void run(int setting) {
        pictures.run(setting);
    }

    @Override
    public void close() {
        pictures.close();
    }
}
