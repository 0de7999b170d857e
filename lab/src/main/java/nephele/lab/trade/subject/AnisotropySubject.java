package nephele.lab.trade.subject;

import java.util.List;
import nephele.lab.trade.Trade;

/** Quality field {@code anisotropy}. */
public final class AnisotropySubject {
    private static final String FIELD = "anisotropy";

    public static final Trade TRADE = PictureTrade.of(
            FIELD,
            new Trade.Text(
                    "Texture anisotropy",
                    "How many samples a texture takes along the steep direction of a floor or wall that is seen at a"
                            + " grazing angle. One sample blurs the far end of floors.",
                    "the oracle: rays through the level, many a pixel"),
            List.of(FIELD),
            "1",
            List.of(
                    PictureSetting.of(FIELD, 1, "low, medium and high"),
                    PictureSetting.of(FIELD, 2, ""),
                    PictureSetting.of(FIELD, 4, ""),
                    PictureSetting.of(FIELD, 8, "ultra"),
                    PictureSetting.of(FIELD, 16, "the most that drivers offer")));

    private AnisotropySubject() {}
}
