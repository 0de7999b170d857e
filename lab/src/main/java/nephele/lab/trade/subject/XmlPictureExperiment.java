package nephele.lab.trade.subject;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.measure.ErrorMap;
import nephele.engine.measure.Flip;
import nephele.engine.measure.LinearPicture;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.lab.bench.SceneDrawing;
import nephele.lab.trade.Experiment;
import nephele.lab.trade.Judgement;
import nephele.lab.trade.TradeSite;
import nephele.scenes.fixed.FixedSceneDrawing;
import nephele.scenes.fixed.SceneAppearance;
import nephele.scenes.fixed.SceneFiles;
import nephele.scenes.fixed.Shading;
import nephele.scenes.xml.XmlScene;

/** A scene drawn in several variants, compared with an exact drawing at 16 samples a pixel. */
final class XmlPictureExperiment implements Experiment {
    static final List<String> FIGURES = List.of("relMSE", "mean bias %", "FLIP, 99th percentile of pixels");

    private static final int EXACT_SIDE = 4;

    private final TradeSite site;
    private final Variant exactVariant;
    private final List<Variant> variants;
    private final List<SceneDrawing> drawn = new ArrayList<>();
    private LinearPicture exact;

    /** A way to generate and shade a scene. */
    record Variant(XmlScene scene, SceneFiles files, Shading shading) {}

    XmlPictureExperiment(TradeSite site, Variant exactVariant, List<Variant> variants) {
        this.site = site;
        this.exactVariant = exactVariant;
        this.variants = variants;
        variants.forEach(variant -> drawn.add(null));
    }

    private SceneDrawing scene(Variant variant, int side) {
        int width = side * site.extent().width();
        int height = side * site.extent().height();
        var source = new FixedSceneDrawing.Source(variant.scene(), variant.files());
        return new SceneDrawing(
                site.gl(),
                FixedSceneDrawing.load(site.gl(), new FixedSceneDrawing.Sources(source, null, null)),
                FixedSceneDrawing.view(variant.scene().eye(), (double) width / height),
                SceneAppearance.USUAL.with(variant.shading()),
                RenderTarget.picture(site.gl(), "trade", PixelFormat.RGBA8, width, height),
                1);
    }

    /** Draws a scene and returns the light that a display emits. */
    private static LinearPicture displayed(SceneDrawing scene) {
        scene.draw(0);
        return ComparedValues.DISPLAY.read(null, scene.picture());
    }

    private SceneDrawing scene(int setting) {
        if (drawn.get(setting) == null) {
            drawn.set(setting, scene(variants.get(setting), 1));
        }
        return drawn.get(setting);
    }

    @Override
    public Judgement judge(int setting) {
        LinearPicture test = displayed(scene(setting));
        ErrorMap flip = Flip.ofDisplayed(reference(), test);
        site.gl().requireNoError("still life");
        return PictureExperiment.judgement(reference(), test, flip, ComparedValues.DISPLAY.shown(test, null));
    }

    private LinearPicture reference() {
        if (exact == null) {
            try (var fine = scene(exactVariant, EXACT_SIDE)) {
                exact = displayed(fine).reduced(EXACT_SIDE);
            }
        }
        return exact;
    }

    @Override
    public BufferedImage exact() {
        return ComparedValues.DISPLAY.shown(reference(), null);
    }

    @Override
    public void run(int setting) {
        scene(setting).draw(0);
        site.gl().finish();
    }

    @Override
    public void close() {
        drawn.stream().filter(scene -> scene != null).forEach(SceneDrawing::close);
    }
}
