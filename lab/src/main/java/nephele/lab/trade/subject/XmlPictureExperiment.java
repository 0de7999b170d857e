package nephele.lab.trade.subject;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.measure.ErrorMap;
import nephele.engine.measure.Flip;
import nephele.engine.measure.LinearPicture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.View;
import nephele.lab.trade.Experiment;
import nephele.lab.trade.Judgement;
import nephele.lab.trade.TradeSite;
import nephele.scenes.fixed.FixedSceneDrawing;
import nephele.scenes.fixed.SceneAppearance;
import nephele.scenes.fixed.SceneFiles;
import nephele.scenes.fixed.Shading;
import nephele.scenes.xml.XmlScene;
import org.joml.Matrix4d;

/** A scene drawn in several variants, compared with an exact drawing at 16 samples a pixel. */
final class XmlPictureExperiment implements Experiment {
    static final List<String> FIGURES = List.of("relMSE", "mean bias %", "FLIP, 99th percentile of pixels");

    private static final int EXACT_SIDE = 4;

    private final TradeSite site;
    private final Variant exactVariant;
    private final List<Variant> variants;
    private final List<DrawnScene> drawn = new ArrayList<>();
    private LinearPicture exact;

    /** A way to generate and shade a scene. */
    record Variant(XmlScene scene, SceneFiles files, Shading shading) {}

    XmlPictureExperiment(TradeSite site, Variant exactVariant, List<Variant> variants) {
        this.site = site;
        this.exactVariant = exactVariant;
        this.variants = variants;
        variants.forEach(variant -> drawn.add(null));
    }

    private DrawnScene scene(Variant variant, int side) {
        int width = side * site.extent().width();
        int height = side * site.extent().height();
        var look = SceneAppearance.USUAL.with(variant.shading());
        return DrawnScene.of(site.gl(), variant.scene(), variant.files(), look, width, height);
    }

    private DrawnScene scene(int setting) {
        if (drawn.get(setting) == null) {
            drawn.set(setting, scene(variants.get(setting), 1));
        }
        return drawn.get(setting);
    }

    @Override
    public Judgement judge(int setting) {
        LinearPicture test = scene(setting).displayed();
        ErrorMap flip = Flip.ofDisplayed(reference(), test);
        site.gl().requireNoError("still life");
        return PictureExperiment.judgement(reference(), test, flip, ComparedValues.DISPLAY.shown(test, null));
    }

    private LinearPicture reference() {
        if (exact == null) {
            try (var fine = scene(exactVariant, EXACT_SIDE)) {
                exact = fine.displayed().reduced(EXACT_SIDE);
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
        scene(setting).draw();
        site.gl().finish();
    }

    @Override
    public void close() {
        drawn.stream().filter(scene -> scene != null).forEach(DrawnScene::close);
    }

    /** An XML scene loaded for drawing one variant, with the picture that it is drawn into. */
    private record DrawnScene(FixedSceneDrawing drawing, View view, SceneAppearance look, RenderTarget picture)
            implements AutoCloseable {
        private static final Matrix4d AT_HOME = new Matrix4d();

        static DrawnScene of(
                GlContext gl, XmlScene scene, SceneFiles files, SceneAppearance look, int width, int height) {
            var source = new FixedSceneDrawing.Source(scene, files);
            return new DrawnScene(
                    FixedSceneDrawing.load(gl, new FixedSceneDrawing.Sources(source, null, null)),
                    FixedSceneDrawing.view(scene.eye(), (double) width / height),
                    look,
                    RenderTarget.picture(gl, "trade", PixelFormat.RGBA8, width, height));
        }

        void draw() {
            drawing.draw(view, 0, AT_HOME, look, picture);
        }

        /** Draws the scene and returns the light that a display emits. */
        LinearPicture displayed() {
            draw();
            return ComparedValues.DISPLAY.read(null, picture);
        }

        @Override
        public void close() {
            drawing.close();
            picture.close();
        }
    }
}
