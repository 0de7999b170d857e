package nephele.lab.trade.subject;

import java.util.List;
import java.util.stream.Stream;
import nephele.lab.trade.Trade;

/** The fields of quality for terrains, judged in the sample of a terrain. */
public final class TerrainSubjects {
    private static final String LEVEL = "levels/samples/terrain.json";
    private static final String ORACLE = "the oracle: rays through the level, many a pixel";

    private static final Trade.Text DETAIL_TEXT = new Trade.Text(
            "Triangles of terrains",
            "All triangles of the height map, or as many as the picture needs: tiles of coarser triangles, chosen for"
                    + " each view, whose error stays below terrainErrorPixels. Light is that of all samples.",
            ORACLE);

    public static final Trade DETAIL = subject(
            "terrainDetail",
            DETAIL_TEXT,
            "lod",
            List.of(
                    PictureSetting.of("terrainDetail", "full", ""),
                    PictureSetting.of("terrainDetail", "lod", "all presets")));

    private static final Trade.Text ERROR_TEXT = new Trade.Text(
            "Error of terrains",
            "How many drawn pixels coarser triangles may show a point of the ground from its place.",
            ORACLE);

    public static final Trade ERROR = subject(
            "terrainErrorPixels",
            ERROR_TEXT,
            "1",
            Stream.of("0.5", "1", "2", "4", "8")
                    .map(pixels ->
                            PictureSetting.of("terrainErrorPixels", pixels, pixels.equals("1") ? "all presets" : ""))
                    .toList());

    private static final Trade.Text LAYERS_TEXT = new Trade.Text(
            "Layers of terrains",
            "Layers of materials are mixed at each pixel, or once into a picture of the whole terrain, as a source of"
                    + " 2010 did: then near ground is blurred and cliffs stretch it.",
            ORACLE);

    public static final Trade LAYERS = subject(
            "terrainLayers",
            LAYERS_TEXT,
            "mixed",
            List.of(
                    PictureSetting.of("terrainLayers", "mixed", "all presets"),
                    PictureSetting.of("terrainLayers", "baked", "")));

    private TerrainSubjects() {}

    private static Trade subject(String field, Trade.Text text, String usual, List<PictureSetting> settings) {
        return PictureSubjects.of(field, text, List.of(field), usual, settings).in(LEVEL, field, text);
    }
}
