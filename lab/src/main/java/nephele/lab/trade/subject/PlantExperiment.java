package nephele.lab.trade.subject;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import nephele.engine.level.Billboards.Facing;
import nephele.engine.measure.ImageError;
import nephele.engine.measure.LinearPicture;
import nephele.lab.trade.Experiment;
import nephele.lab.trade.Judgement;
import nephele.lab.trade.Setting;
import nephele.lab.trade.TradeSite;

/**
 * Techniques that draw plants. A still picture is compared with the reference picture's; frames along two paths with those of meshes at 64
 * samples a pixel, displayed light of eight times the pixels along each side, averaged.
 */
final class PlantExperiment implements Experiment {
    static final List<String> FIGURES = List.of(
            "relMSE",
            "mean bias %",
            "HDR-FLIP, 99th percentile of pixels",
            "flicker, view turns",
            "flicker, eye moves");

    /** A technique that draws plants, in the order of growing cost. */
    enum Technique {
        SPRITES("sprites", "one picture, turned to the eye"),
        CROSSED("crossed sprites", "two pictures at right angles"),
        IMPOSTORS("impostors", "64 pictures, at every distance"),
        MIXTURE("mixture", "all presets: impostors below 64 pixels, meshes above"),
        MESHES("meshes", "at every distance");

        private final Setting setting;

        Technique(String name, String note) {
            setting = new Setting(name, note);
        }

        Setting setting() {
            return setting;
        }

        PictureSetting of(PlantSprites sprites) {
            return new PictureSetting(setting, shot -> of(shot, sprites));
        }

        private Shot of(Shot shot, PlantSprites sprites) {
            return switch (this) {
                case SPRITES -> shot.with(sprites.in(shot.level(), Facing.CYLINDRICAL));
                case CROSSED -> shot.with(sprites.in(shot.level(), Facing.CROSSED));
                case IMPOSTORS -> shot.set("impostorPixels", 256);
                case MIXTURE -> shot;
                case MESHES -> shot.set("impostorPixels", 0);
            };
        }
    }

    private static final int EXACT_SIDE = 8;

    private final TradeSite site;
    private final PictureExperiment pictures;
    private final Footage turning;
    private final Footage moving;
    /** The displayed light of meshes along the two paths; {@code null} before the first judgement. */
    private List<LinearPicture> exactTurning;

    private List<LinearPicture> exactMoving;

    /** @param planted of a level with impostors */
    PlantExperiment(TradeSite planted) {
        PlantSprites sprites = PlantSprites.of(planted.placed());
        site = planted.with(sprites.assets());
        pictures = new PictureExperiment(
                site,
                Stream.of(Technique.values())
                        .map(technique -> technique.of(sprites))
                        .toList(),
                ComparedValues.RADIANCE);
        turning = Footage.path(site);
        moving = Footage.run(site);
    }

    @Override
    public Judgement judge(int setting) {
        Judgement still = pictures.judge(setting);
        drawExact();
        List<Double> figures = new ArrayList<>(still.figures());
        try (var renderer = pictures.renderer(pictures.shot(setting))) {
            figures.add(ImageError.shimmer(exactTurning, turning.displayed(site.gl(), renderer, 1)));
            figures.add(ImageError.shimmer(exactMoving, moving.displayed(site.gl(), renderer, 1)));
        }
        return new Judgement(still.error(), List.copyOf(figures), still.picture(), still.map());
    }

    private void drawExact() {
        if (exactTurning == null) {
            try (var renderer = pictures.renderer(pictures.shot(Technique.MESHES.ordinal()))) {
                exactTurning = turning.displayed(site.gl(), renderer, EXACT_SIDE);
                exactMoving = moving.displayed(site.gl(), renderer, EXACT_SIDE);
            }
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
    }
}
