package nephele.lab.trade.subject;

import java.awt.image.BufferedImage;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import nephele.engine.measure.ErrorMap;
import nephele.engine.measure.Flip;
import nephele.engine.measure.ImageError;
import nephele.engine.measure.LinearPicture;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.host.draw.IdLevel;
import nephele.host.terminal.CommandFailure;
import nephele.lab.trade.CostMetric;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.Experiment;
import nephele.lab.trade.Judgement;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;
import nephele.lab.trade.TradeSite;

/**
 * Multisampling and antialiasing, compared with the engine's own picture at 64 samples a pixel: displayed light of eight times the
 * pixels along each side, averaged. A still picture is judged, and the shimmer along a path.
 */
public final class EdgeExperiment implements Experiment {
    private static final List<String> FIGURES = List.of("shimmer", "RMSE at edges", "FLIP, 99th percentile of pixels");
    private static final String REFERENCE_TEXT =
            "the engine's own picture of 64 samples a pixel: eight times the pixels along each side, averaged in"
                + " linear light. Shimmer is the RMS change of the error from frame to frame while the view turns by"
                + " 0.3 pixels a frame, over " + Footage.PATH_FRAMES + " frames of at most "
                    + Footage.PATH_WIDTH + "×" + Footage.PATH_HEIGHT
                    + " pixels. RMSE at edges counts pixels at most one pixel from the edge of a surface. Both are in"
                    + " linear light, 1 is white; the advice regards FLIP alone";
    public static final Trade SAMPLES = trade("samples", PictureSetting.all("samples", 1, 2, 4, 8));
    public static final Trade ANTIALIASING = trade(
            "antialiasing",
            List.of(
                    filter("none"),
                    filter("morphological"),
                    filter("temporal"),
                    temporal("0.75"),
                    temporal("0.6"),
                    new PictureSetting(
                            new Setting("4 samples", "instead of the filter"), shot -> shot.set("samples", "4"))));

    private static final int EXACT_SIDE = 8;

    private final TradeSite site;
    private final PictureExperiment pictures;
    private final Footage still;
    private final Footage path;
    /** The displayed light of the exact still picture; {@code null} before it is drawn. */
    private LinearPicture exactStill;

    private List<LinearPicture> exactPath;
    private boolean[] nearEdges;

    private EdgeExperiment(TradeSite site, List<PictureSetting> settings) {
        this.site = site;
        requireRoom(site.extent(), site.gl().limits().maxTextureSize());
        pictures = new PictureExperiment(site, settings, ComparedValues.DISPLAY);
        still = Footage.still(site);
        path = Footage.path(site);
    }

    private static void requireRoom(TradeSite.Extent extent, int most) {
        if (EXACT_SIDE * Math.max(extent.width(), extent.height()) > most) {
            int side = most / EXACT_SIDE;
            throw CommandFailure.usage("edges are compared with a picture of " + EXACT_SIDE
                    + " times the pixels along each side, and this OpenGL draws at most " + most
                    + ": choose a --size of at most " + side + "x" + side);
        }
    }

    @Override
    public Judgement judge(int setting) {
        drawExact();
        try (var renderer = pictures.renderer(pictures.shot(setting))) {
            LinearPicture test = still.displayed(site.gl(), renderer, 1).get(0);
            ErrorMap flip = Flip.ofDisplayed(exactStill, test);
            List<Double> figures = List.of(
                    ImageError.shimmer(exactPath, path.displayed(site.gl(), renderer, 1)),
                    ImageError.rootMeanSquare(exactStill, test, nearEdges),
                    flip.quantile(0.99));
            return new Judgement(flip.mean(), figures, shown(test), flip);
        }
    }

    /** Draws the exact pictures at the first call, because all settings have the same. */
    private void drawExact() {
        if (exactStill == null) {
            try (var renderer =
                    pictures.renderer(pictures.shot(0).set("samples", 1).set("antialiasing", "none"))) {
                exactStill = still.displayed(site.gl(), renderer, EXACT_SIDE).get(0);
                exactPath = path.displayed(site.gl(), renderer, EXACT_SIDE);
            }
            nearEdges = nearEdges();
        }
    }

    /** Returns the pixels of the still picture within a pixel of the edge of a surface. */
    private boolean[] nearEdges() {
        var ids = new Shot(IdLevel.of(site.level()), Output.PLAIN, "high", Map.of("debug", "ids"));
        try (var renderer = pictures.renderer(ids);
                var picture =
                        RenderTarget.picture(site.gl(), "ids", PixelFormat.RGBA8, still.width(), still.height())) {
            renderer.draw(site.view(), picture);
            return nearEdges(picture.readBytes(), still.width(), still.height());
        }
    }

    @Override
    public BufferedImage exact() {
        drawExact();
        return shown(exactStill);
    }

    private BufferedImage shown(LinearPicture picture) {
        return ComparedValues.DISPLAY.shown(picture, site.level().environment());
    }

    @Override
    public void run(int setting) {
        pictures.run(setting);
    }

    @Override
    public void close() {
        pictures.close();
    }

    /**
     * Returns for each pixel whether one of the eight around it shows another surface.
     *
     * @param rgba the colours, row by row
     */
    static boolean[] nearEdges(ByteBuffer rgba, int width, int height) {
        boolean[] near = new boolean[width * height];
        for (int i = 0; i < near.length; i++) {
            int column = i % width;
            int row = i / width;
            for (int y = Math.max(row - 1, 0); y <= Math.min(row + 1, height - 1); y++) {
                for (int x = Math.max(column - 1, 0); x <= Math.min(column + 1, width - 1); x++) {
                    near[i] |= rgba.getInt(4 * (y * width + x)) != rgba.getInt(4 * i);
                }
            }
        }
        return near;
    }

    /** Returns a filter's setting with one sample a pixel, also where the preset has more. */
    private static PictureSetting filter(String value) {
        return new PictureSetting(
                PictureSetting.of("antialiasing", value).setting(),
                shot -> shot.set("antialiasing", value).set("samples", 1));
    }

    /** Returns the setting of frames that are averaged, with a share of the pixels along a side. */
    private static PictureSetting temporal(String resolution) {
        PictureSetting whole = filter("temporal");
        return new PictureSetting(
                new Setting("temporal " + resolution, "of the pixels along each side"),
                shot -> whole.change().apply(shot).set("pictureResolution", resolution));
    }

    private static Trade trade(String subject, List<PictureSetting> settings) {
        List<Setting> named = settings.stream().map(PictureSetting::setting).toList();
        return new Trade(
                subject,
                PictureSubjects.text(subject, REFERENCE_TEXT),
                List.of(subject),
                named,
                named.stream().map(Setting::name).toList().indexOf(PictureSubjects.usual(subject)),
                ErrorMetric.DISPLAYED,
                FIGURES,
                CostMetric.FRAME,
                null,
                site -> new EdgeExperiment(site, settings));
    }
}
