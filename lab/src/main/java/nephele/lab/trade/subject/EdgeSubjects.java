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

    public static final Trade SAMPLES = of("samples", PictureSetting.all("samples", 1, 2, 4, 8));

    public static final Trade FILTER = of(
            "edgeFilter",
            List.of(
                    filter("none"),
                    filter("morphological"),
                    new PictureSetting(
                            new Setting("4 samples", "instead of the filter"), shot -> shot.set("samples", "4"))));

    private EdgeSubjects() {}

    /** Returns a filter's setting with one sample a pixel, also where the preset has more. */
    private static PictureSetting filter(String value) {
        return new PictureSetting(
                PictureSetting.of("edgeFilter", value).setting(),
                shot -> shot.set("edgeFilter", value).set("samples", 1));
    }

    private static Trade of(String subject, List<PictureSetting> settings) {
        List<Setting> named = settings.stream().map(PictureSetting::setting).toList();
        return new Trade(
                subject,
                PictureSubjects.text(subject, EXACT),
                List.of(subject),
                named,
                named.stream().map(Setting::name).toList().indexOf(PictureSubjects.usual(subject)),
                ErrorMetric.DISPLAYED,
                EdgeExperiment.FIGURES,
                CostMetric.FRAME,
                null,
                site -> new EdgeExperiment(site, settings));
    }
}
