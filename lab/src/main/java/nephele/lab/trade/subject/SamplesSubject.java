package nephele.lab.trade.subject;

import java.util.List;
import nephele.lab.trade.Trade;

/** Quality field {@code samples}. */
public final class SamplesSubject {
    private static final String FIELD = "samples";

    public static final Trade TRADE = PictureTrade.of(
            FIELD,
            new Trade.Text(
                    "Samples a pixel",
                    "Edges of walls, portals and things are smoothed by testing coverage at several points of a pixel"
                            + " (multisampling). One point gives stairs.",
                    "the oracle: rays through the level, many a pixel"),
            List.of(FIELD),
            "1",
            List.of(
                    PictureSetting.of(FIELD, 1, "low, medium and high"),
                    PictureSetting.of(FIELD, 2, ""),
                    PictureSetting.of(FIELD, 4, "ultra"),
                    PictureSetting.of(FIELD, 8, "")));

    private SamplesSubject() {}
}
