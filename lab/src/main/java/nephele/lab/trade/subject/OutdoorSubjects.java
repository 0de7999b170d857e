package nephele.lab.trade.subject;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import nephele.engine.level.Billboards.Facing;
import nephele.engine.level.Level;
import nephele.lab.trade.CostMetric;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;

/** How terrain, billboards and models that may be impostors are drawn, judged in their samples. */
public final class OutdoorSubjects {
    private static final String REFERENCE = "the oracle: rays through the level, many a pixel";
    private static final String FOREST = "levels/samples/impostors.json";
    public static final Trade IMPOSTORS = PictureSubjects.setting(
                    "impostorPixels",
                    REFERENCE,
                    Stream.concat(
                                    Stream.of(PictureSetting.of("impostorPixels", 0, "meshes alone")),
                                    PictureSetting.all("impostorPixels", 32, 64, 96, 128).stream())
                            .toList())
            .in(FOREST);
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
            Stream.of(PlantExperiment.Technique.values())
                    .map(PlantExperiment.Technique::setting)
                    .toList(),
            PlantExperiment.Technique.MIXTURE.ordinal(),
            ErrorMetric.PICTURE,
            PlantExperiment.FIGURES,
            CostMetric.FRAME,
            FOREST,
            site -> new PlantExperiment(site.in(FOREST)));

    private static final String BILLBOARDS = "levels/samples/billboards.json";
    private static final Trade.Text SPRITE_FACING_TEXT = new Trade.Text(
            "Turning of billboards",
            "Those of the sample that are upright and turned to the eye, turned in other ways or crossed, which takes"
                    + " twice the pictures. The formula of the source faces away from eyes at smaller z, so it errs"
                    + " nothing in this view. Which way is nearest to a tree is what treeKind says.",
            REFERENCE + ", each of which meets the sample's own billboards, turned to it");
    public static final Trade SPRITE_FACING = PictureSubjects.of(
                    "spriteFacing",
                    SPRITE_FACING_TEXT,
                    List.of(),
                    "cylindrical",
                    Stream.of(Facing.CYLINDRICAL, Facing.SPHERICAL, Facing.SCREEN, Facing.CROSSED, Facing.SOURCE)
                            .map(OutdoorSubjects::turned)
                            .toList())
            .in(BILLBOARDS, "spriteFacing", SPRITE_FACING_TEXT);
    public static final Trade SPRITE_COVERAGE = PictureSubjects.setting(
                    "spriteCoverage", REFERENCE, PictureSetting.all("spriteCoverage", "kept", "mean"))
            .in(BILLBOARDS);

    private static final String TERRAIN = "levels/samples/terrain.json";

    public static final Trade TERRAIN_DETAIL = PictureSubjects.setting(
                    "terrainDetail", REFERENCE, PictureSetting.all("terrainDetail", "full", "lod"))
            .in(TERRAIN);

    public static final Trade TERRAIN_ERROR = PictureSubjects.setting(
                    "terrainErrorPixels",
                    REFERENCE,
                    PictureSetting.all("terrainErrorPixels", "0.5", "1", "2", "4", "8"))
            .in(TERRAIN);

    public static final Trade TERRAIN_LAYERS = PictureSubjects.setting(
                    "terrainLayers", REFERENCE, PictureSetting.all("terrainLayers", "mixed", "baked"))
            .in(TERRAIN);

    private OutdoorSubjects() {}

    /** How billboards are turned and filtered, judged in their sample. */
    private static PictureSetting turned(Facing facing) {
        return new PictureSetting(
                Setting.of(facing.name().toLowerCase(Locale.ROOT)), shot -> shot.with(turned(shot.level(), facing)));
    }

    private static Level turned(Level level, Facing facing) {
        return level.withBillboards(level.billboards().stream()
                .map(group -> group.facing() == Facing.CYLINDRICAL ? group.turned(facing) : group)
                .toList());
    }
}
