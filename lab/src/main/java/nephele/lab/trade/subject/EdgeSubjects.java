package nephele.lab.trade.subject;

import java.util.List;
import nephele.lab.trade.CostMetric;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;

/** Multisampling and the edge filter, compared with the same reference. */
public final class EdgeSubjects {
    private static final String EXACT = "the engine's own picture of 64 samples a pixel: eight times the pixels along"
            + " each side, averaged in linear light. Shimmer is the RMS change of the error from frame to frame while"
            + " the view turns by 0.3 pixels a frame, over " + Footage.PATH_FRAMES + " frames of at most "
            + Footage.PATH_WIDTH + "×" + Footage.PATH_HEIGHT + " pixels. RMSE at edges counts pixels at most one pixel"
            + " from the edge of a surface. Both are in linear light, 1 is white; the advice regards FLIP alone";

    public static final Trade SAMPLES = of(
            "samples",
            new Trade.Text(
                    "Samples a pixel",
                    "Edges of walls, portals and dynamic objects are smoothed by testing coverage at several points of"
                            + " a pixel (multisampling). One point gives stairs.",
                    EXACT),
            "1",
            List.of(
                    PictureSetting.of("samples", 1, "low, medium and high"),
                    PictureSetting.of("samples", 2, ""),
                    PictureSetting.of("samples", 4, "ultra"),
                    PictureSetting.of("samples", 8, "")));

    public static final Trade FILTER = of(
            "edgeFilter",
            new Trade.Text(
                    "Filter of edges",
                    "Stairs along edges are smoothed in the displayed picture, by the edges' shapes. It costs a"
                            + " fraction of samples, and sees no detail that is smaller than a pixel.",
                    EXACT),
            "none",
            List.of(
                    filter("none", "all presets"),
                    filter("morphological", ""),
                    new PictureSetting(
                            new Setting("4 samples", "instead of the filter"), shot -> shot.set("samples", "4"))));

    private EdgeSubjects() {}

    /** Returns a filter's setting with one sample a pixel, also where the preset has more. */
    private static PictureSetting filter(String value, String note) {
        return new PictureSetting(
                new Setting(value, note), shot -> shot.set("edgeFilter", value).set("samples", 1));
    }

    private static Trade of(String subject, Trade.Text text, String usual, List<PictureSetting> settings) {
        List<Setting> named = settings.stream().map(PictureSetting::setting).toList();
        return new Trade(
                subject,
                text,
                List.of(subject),
                named,
                named.stream().map(Setting::name).toList().indexOf(usual),
                ErrorMetric.DISPLAYED,
                EdgeExperiment.FIGURES,
                CostMetric.FRAME,
                null,
                site -> new EdgeExperiment(site, settings));
    }
}
