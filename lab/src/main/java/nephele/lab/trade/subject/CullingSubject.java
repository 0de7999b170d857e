package nephele.lab.trade.subject;

import java.util.List;
import nephele.lab.trade.Trade;

/** `--set culling=`. */
public final class CullingSubject {
    private static final String KEY = "culling";

    public static final Trade TRADE = PictureTrade.of(
            KEY,
            new Trade.Text(
                    "Leaving out what is out of view",
                    "Solids that the view cannot show are not sent to the renderer: none left out, a sphere around"
                            + " each tested, or boxes around groups of them tested first. Pictures must not differ.",
                    "the oracle: rays through the level, many a pixel"),
            List.of(),
            "hierarchy",
            List.of(
                    PictureSetting.of(KEY, "none", "everything is drawn"),
                    PictureSetting.of(KEY, "sphere", "one after the other"),
                    PictureSetting.of(KEY, "hierarchy", "all presets")));

    public static final Trade OF_MANY = Elsewhere.of(
            TRADE,
            "cullingBoxes",
            new Trade.Text(
                    "Leaving out some of ten thousand",
                    "The same among ten thousand boxes, most of them out of view.",
                    "the oracle: rays through the level, many a pixel"),
            "levels/bench/boxes-10000.json");

    private CullingSubject() {}
}
