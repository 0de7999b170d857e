package nephele.lab.trade.subject;

import java.util.List;
import java.util.stream.Stream;
import nephele.lab.trade.CostMetric;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.Trade;

/** How models are drawn that may be impostors, judged in the sample of a forest. */
public final class ImpostorSubject {
    private static final String LEVEL = "levels/samples/impostors.json";

    public static final Trade IMPOSTORS = PictureSubjects.setting(
                    "impostorPixels",
                    "the oracle: rays through the level, many a pixel",
                    Stream.concat(
                                    Stream.of(PictureSetting.of("impostorPixels", 0, "meshes alone")),
                                    PictureSetting.all("impostorPixels", 32, 64, 96, 128).stream())
                            .toList())
            .in(LEVEL);

    public static final Trade TREES = new Trade(
            "treeKind",
            new Trade.Text(
                    "Trees: sprites, crossed sprites, impostors, meshes",
                    "The same trees at the same places and heights: one picture turned to the eye, two crossed ones"
                            + " that stand still, 64 pictures of which three are blended, their meshes where they are"
                            + " large, or meshes alone. A sprite's picture is the impostor's from one side, without"
                            + " light.",
                    "the oracle: rays through the meshes, many a pixel. Flicker is the RMS change of the error from"
                            + " frame to frame, over " + Footage.PATH_FRAMES + " frames of at most "
                            + Footage.PATH_WIDTH + "×" + Footage.PATH_HEIGHT + " pixels, against meshes of 64 samples"
                            + " a pixel, in linear light, 1 is white: while the view turns by 0.3 pixels a frame,"
                            + " where only leaves and edges finer than a pixel flicker, and while the eye moves to the"
                            + " side by 0.1 m a frame, a run at 60 frames a second, where sprites also turn and have"
                            + " no parallax. A picture that is wrong and moves counts in both; the advice regards"
                            + " HDR-FLIP alone"),
            List.of(),
            Stream.of(PlantWay.values()).map(PlantWay::setting).toList(),
            PlantWay.MIXTURE.ordinal(),
            ErrorMetric.PICTURE,
            PlantExperiment.FIGURES,
            CostMetric.FRAME,
            LEVEL,
            site -> new PlantExperiment(site.in(LEVEL)));

    private ImpostorSubject() {}
}
