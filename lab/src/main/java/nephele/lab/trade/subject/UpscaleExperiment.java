package nephele.lab.trade.subject;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import nephele.engine.measure.ErrorMap;
import nephele.engine.measure.Flip;
import nephele.engine.measure.ImageError;
import nephele.engine.measure.LinearPicture;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.host.draw.IdLevel;
import nephele.lab.trade.CostMetric;
import nephele.lab.trade.Experiment;
import nephele.lab.trade.Judgement;
import nephele.lab.trade.TradeSite;

/**
 * Sizes of the drawn picture and the filters that scale it up, in five levels: FLIP to the whole picture, shimmer along a
 * path relative to 16 samples a pixel, and how far flat colours overshoot beside their edges. A run draws a frame of each
 * level.
 */
final class UpscaleExperiment implements Experiment {
    private static final List<String> LEVELS = Stream.of(
                    "01-courtyard", "02-first-shot", "03-momentum", "04-cube", "06-standing-stones")
            .map(name -> "levels/" + name + ".json")
            .toList();

    static final List<String> FIGURES = Stream.concat(
                    Stream.of("shimmer", "halo, codes"), LEVELS.stream().map(name -> "FLIP " + name.substring(7, 9)))
            .toList();

    /** A run draws a frame of each level. */
    static final CostMetric COST = new CostMetric("CPU a frame", "ms", 1e6, LEVELS.size(), CostMetric.Clock.PROCESS);

    private static final int EXACT_SIDE = 4;

    /** Further than any filter reaches: three drawn pixels at half the size. */
    private static final int REACH_PIXELS = 6;

    private final List<InLevel> levels;
    private final TradeSite site;

    UpscaleExperiment(TradeSite site, List<PictureSetting> settings) {
        this.site = site;
        levels = LEVELS.stream()
                .map(level -> new InLevel(site.in(level), settings))
                .toList();
    }

    @Override
    public Judgement judge(int setting) {
        List<LinearPicture> stills = new ArrayList<>();
        List<ErrorMap> flips = new ArrayList<>();
        List<Double> shimmers = new ArrayList<>();
        for (InLevel level : levels) {
            try (var renderer = level.pictures.renderer(level.pictures.shot(setting))) {
                LinearPicture still =
                        level.still.displayed(site.gl(), renderer, 1).get(0);
                stills.add(still);
                flips.add(Flip.ofDisplayed(level.whole, still));
                shimmers.add(ImageError.shimmer(level.exactPath, level.path.displayed(site.gl(), renderer, 1)));
            }
        }
        List<Double> errors = flips.stream().map(ErrorMap::mean).toList();
        List<Double> figures = new ArrayList<>();
        figures.add(mean(shimmers));
        figures.add((double) levels.get(0).halo(setting));
        figures.addAll(errors);
        return new Judgement(mean(errors), figures, levels.get(0).shown(stills.get(0)), flips.get(0));
    }

    private static double mean(List<Double> values) {
        return values.stream().mapToDouble(Double::doubleValue).average().orElseThrow();
    }

    @Override
    public BufferedImage exact() {
        return levels.get(0).shown(levels.get(0).whole);
    }

    @Override
    public void run(int setting) {
        levels.forEach(level -> level.pictures.run(setting));
        site.gl().finish();
    }

    @Override
    public void close() {
        levels.forEach(level -> level.pictures.close());
    }

    /** The settings in one of the levels. */
    private static final class InLevel {
        final PictureExperiment pictures;
        final LinearPicture whole;
        private final TradeSite site;
        final Footage still;
        final Footage path;
        final List<LinearPicture> exactPath;

        InLevel(TradeSite site, List<PictureSetting> settings) {
            this.site = site;
            pictures = new PictureExperiment(site, settings, ComparedValues.SEEN);
            still = Footage.still(site);
            path = Footage.path(site);
            Shot usual = pictures.shot(0).set("pictureResolution", 1);
            try (var renderer = pictures.renderer(usual)) {
                whole = still.displayed(site.gl(), renderer, 1).get(0);
                exactPath = path.displayed(site.gl(), renderer, EXACT_SIDE);
            }
        }

        /** Returns how far flat colours, those of the surfaces' ids, leave the range of the drawn pixels around them. */
        int halo(int setting) {
            var shot = pictures.shot(setting);
            var flat = new Shot(IdLevel.of(shot.level()), Output.PLAIN, shot.preset(), shot.set()).set("rims", "off");
            var whole = flat.set("pictureResolution", 1);
            double fraction = flat.settings(true).quality().pictureResolution();
            int width = (int) Math.round(fraction * still.width());
            int height = (int) Math.round(fraction * still.height());
            byte[] small = stored(whole, width, height);
            byte[] enlarged = new byte[4 * still.width() * still.height()];
            for (int pixel = 0; pixel < still.width() * still.height(); pixel++) {
                int column = (int) ((pixel % still.width() + 0.5) * width / still.width());
                int row = (int) ((pixel / still.width() + 0.5) * height / still.height());
                System.arraycopy(small, 4 * (row * width + column), enlarged, 4 * pixel, 4);
            }
            return ImageError.overshoot(
                    enlarged, stored(flat, still.width(), still.height()), still.width(), REACH_PIXELS);
        }

        private byte[] stored(Shot shot, int width, int height) {
            try (var renderer = pictures.renderer(shot);
                    var picture = RenderTarget.picture(site.gl(), "flat colours", PixelFormat.RGBA8, width, height)) {
                renderer.draw(site.view(), picture);
                var bytes = picture.readBytes();
                byte[] stored = new byte[bytes.remaining()];
                bytes.get(stored);
                return stored;
            }
        }

        BufferedImage shown(LinearPicture picture) {
            return ComparedValues.SEEN.shown(picture, site.level().environment());
        }
    }
}
