package nephele.lab.trade.subject;

import java.util.List;
import java.util.stream.Stream;
import nephele.lab.trade.Trade;

/** The size below which models are drawn as impostors, judged in the sample of a forest. */
public final class ImpostorSubject {
    private static final String LEVEL = "levels/samples/impostors.json";

    private static final Trade.Text TEXT = new Trade.Text(
            "Impostors of models",
            "How many pixels a model has where its impostor takes the place of its mesh; 0 draws meshes alone. An"
                    + " impostor is a rectangle with pictures of the model from three directions, lit as the mesh is.",
            "the oracle: rays through the level, many a pixel");

    public static final Trade IMPOSTORS = PictureSubjects.of(
                    "impostorPixels",
                    TEXT,
                    List.of("impostorPixels"),
                    "64",
                    Stream.of("0", "32", "64", "96", "128")
                            .map(pixels -> PictureSetting.of(
                                    "impostorPixels",
                                    pixels,
                                    pixels.equals("64") ? "all presets" : pixels.equals("0") ? "meshes alone" : ""))
                            .toList())
            .in(LEVEL, "impostorPixels", TEXT);

    private ImpostorSubject() {}
}
