package nephele.lab.trade.subject;

import nephele.lab.trade.Trade;

/** The fields of quality for terrains, judged in the sample of a terrain. */
public final class TerrainSubjects {
    private static final String LEVEL = "levels/samples/terrain.json";
    private static final String ORACLE = "the oracle: rays through the level, many a pixel";

    public static final Trade DETAIL = PictureSubjects.setting(
                    "terrainDetail", ORACLE, PictureSetting.all("terrainDetail", "full", "lod"))
            .in(LEVEL);

    public static final Trade ERROR = PictureSubjects.setting(
                    "terrainErrorPixels", ORACLE, PictureSetting.all("terrainErrorPixels", "0.5", "1", "2", "4", "8"))
            .in(LEVEL);

    public static final Trade LAYERS = PictureSubjects.setting(
                    "terrainLayers", ORACLE, PictureSetting.all("terrainLayers", "mixed", "baked"))
            .in(LEVEL);

    private TerrainSubjects() {}
}
