package nephele.lab.trade.subject;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import nephele.engine.bake.LightBake;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.measure.HdrFlip;
import nephele.engine.measure.LinearPicture;
import nephele.engine.reference.LightTransport;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.TracedLevel;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.engine.scene.light.bake.LightMapLayout;
import nephele.engine.scene.light.bake.SkyVisibility;
import nephele.lab.bake.TracedPictures;
import nephele.lab.trade.CostMetric;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.Experiment;
import nephele.lab.trade.Judgement;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;
import nephele.lab.trade.TradeSite;

/** Light that bounces: how far it is followed, how finely it is baked, and whether its directions are. */
public final class BakedLightSubjects {
    private static final List<String> FIGURES = List.of("relMSE", "mean bias %", "HDR-FLIP, 99th percentile of pixels");
    private static final String ROOM = "levels/02-first-shot.json";
    private static final String EXACT = "the oracle: rays through the level, many a pixel, with all light that bounces";

    private static final List<LightTransport> TRANSPORTS = Stream.concat(
                    IntStream.of(0, 1, 2, 4, 8).mapToObj(bounces -> new LightTransport(bounces, false)),
                    Stream.of(LightTransport.BAKED))
            .toList();

    public static final Trade BOUNCES = new Trade(
            "bounces",
            new Trade.Text(
                    "Bounces of light",
                    "The twin follows light over so many surfaces before the one that is seen. What is left after n"
                            + " bounces falls with the albedo to the power of n; Russian roulette ends paths that carry"
                            + " little without an error in the mean.",
                    EXACT + ", along the same paths"),
            List.of(),
            List.of(
                    new Setting("0", "direct light"),
                    Setting.of("1"),
                    Setting.of("2"),
                    Setting.of("4"),
                    Setting.of("8"),
                    new Setting("all", "the usual")),
            TRANSPORTS.size() - 1,
            ErrorMetric.PICTURE,
            FIGURES,
            new CostMetric("CPU a sample of each pixel", "ms", 1e6, 1, CostMetric.Clock.PROCESS),
            ROOM,
            site -> new Traced(site.in(ROOM)));

    public static final Trade TEXELS = of(
            "lightTexels",
            new Trade.Text(
                    "Texels of baked light",
                    "Half the size takes four times the texels, the memory and the time to bake. The sky's"
                            + " shadows and what bounces are soft except in corners.",
                    EXACT),
            List.of(),
            "levels/samples/sky-visibility.json",
            1,
            List.of(
                    new Variant(Setting.of("0.5 m"), 0.5, "live", "on"),
                    new Variant(new Setting("0.25 m", "all presets"), LightMapLayout.TEXEL_METRES, "live", "on"),
                    new Variant(Setting.of("0.125 m"), 0.125, "live", "on")));

    public static final Trade DIRECTIONS = of(
            "lightDirections",
            PictureSubjects.text("lightDirections", EXACT),
            List.of("directLight", "lightDirections"),
            "levels/samples/material-normals.json",
            3,
            List.of(
                    new Variant(new Setting("baked, without", "low"), LightMapLayout.TEXEL_METRES, "baked", "off"),
                    new Variant(new Setting("baked, with", ""), LightMapLayout.TEXEL_METRES, "baked", "on"),
                    new Variant(new Setting("live, without", ""), LightMapLayout.TEXEL_METRES, "live", "off"),
                    new Variant(new Setting("live, with", "high"), LightMapLayout.TEXEL_METRES, "live", "on")));

    private BakedLightSubjects() {}

    /**
     * A way to draw baked light.
     *
     * @param direct value of the setting {@code directLight}
     * @param directions value of {@code lightDirections}
     */
    private record Variant(Setting setting, double texelMetres, String direct, String directions) {}

    private static Trade of(
            String subject, Trade.Text text, List<String> fields, String level, int usual, List<Variant> variants) {
        return new Trade(
                subject,
                text,
                fields,
                variants.stream().map(Variant::setting).toList(),
                usual,
                ErrorMetric.PICTURE,
                FIGURES,
                CostMetric.FRAME,
                level,
                site -> new Drawn(site.in(level), variants));
    }

    private static Judgement judged(TradeSite site, LinearPicture test) {
        LinearPicture exact = site.reference(LightTransport.BAKED);
        BufferedImage shown = ComparedValues.RADIANCE.shown(test, site.level().environment());
        return PictureExperiment.judgement(exact, test, HdrFlip.of(exact, test), shown);
    }

    private static BufferedImage exact(TradeSite site) {
        return ComparedValues.RADIANCE.shown(
                site.reference(LightTransport.BAKED), site.level().environment());
    }

    /** Pictures of the twin. */
    private record Traced(TradeSite site) implements Experiment {
        @Override
        public Judgement judge(int setting) {
            return judged(site, site.reference(TRANSPORTS.get(setting)));
        }

        @Override
        public BufferedImage exact() {
            return BakedLightSubjects.exact(site);
        }

        @Override
        public void run(int setting) {
            TradeSite.Extent extent = site.extent();
            int threads = Runtime.getRuntime().availableProcessors();
            ReferencePicture.trace(
                    TracedLevel.of(site.placed(), ColourDecoding.SRGB),
                    TracedPictures.pinhole(site.view()),
                    new TraceSettings(extent.width(), extent.height(), 1, 1, threads, TRANSPORTS.get(setting)),
                    done -> {});
        }
    }

    /** Pictures of freshly baked light. */
    private static final class Drawn implements Experiment {
        private final TradeSite site;
        private final RenderTarget picture;
        private final List<Renderer> renderers = new ArrayList<>();

        Drawn(TradeSite site, List<Variant> variants) {
            this.site = site;
            TradeSite.Extent extent = site.extent();
            picture =
                    RenderTarget.picture(site.gl(), "baked light", PixelFormat.RGBA8, extent.width(), extent.height());
            Scene scene = null;
            double texelMetres = 0;
            for (Variant variant : variants) {
                if (variant.texelMetres() != texelMetres) {
                    texelMetres = variant.texelMetres();
                    scene = baked(site.placed(), texelMetres);
                }
                Shot shot = ComparedValues.RADIANCE
                        .judged(Shot.high(site.level(), Output.HDR))
                        .set("directLight", variant.direct())
                        .set("lightDirections", variant.directions());
                renderers.add(LevelRenderer.load(
                        site.gl(), scene, shot.settings(site.gl().limits().software())));
            }
        }

        private static Scene baked(PlacedLevel placed, double texelMetres) {
            StaticShapes split = placed.statics().split(SkyVisibility.MODEL_EDGE_METRES);
            LightMapLayout layout = LightMapLayout.withTexels(split.solids(), texelMetres);
            LightBake bake = LightBake.of(placed, LightBake.Settings.USUAL.withError(0.1), layout);
            bake.run(LightBake.Checkpoint.NONE, done -> {});
            short[] texels = new short[layout.width() * layout.height()];
            short[] vertices = new short[split.models().vertexCount()];
            SkyVisibility visibility = new SkyVisibility(layout, split, texels, vertices);
            return Scene.of(placed, new BakedLight(visibility, bake.light()));
        }

        @Override
        public Judgement judge(int setting) {
            for (int frame = 0; frame < PictureExperiment.SETTLING_FRAMES; frame++) {
                run(setting);
            }
            site.gl().requireNoError("baked light");
            float[] radiance = renderers.get(setting).readRadiance();
            return judged(site, new LinearPicture(picture.width(), picture.height(), radiance));
        }

        @Override
        public BufferedImage exact() {
            return BakedLightSubjects.exact(site);
        }

        @Override
        public void run(int setting) {
            renderers.get(setting).draw(site.view(), picture);
            site.gl().finish();
        }

        @Override
        public void close() {
            renderers.forEach(Renderer::close);
            picture.close();
        }
    }
}
