package nephele.lab.trade.subject;

import java.util.List;
import java.util.stream.Stream;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;

/** Quality fields {@code portalTechnique}, {@code viewBudget} and {@code portalResolution}. */
public final class PortalSubjects {
    private static final String TECHNIQUE_FIELD = "portalTechnique";
    private static final String RESOLUTION_FIELD = "portalResolution";
    private static final String REFERENCE = "the oracle: rays go through portals without a limit that shows";

    public static final Trade TECHNIQUE = PictureSubjects.setting(
            TECHNIQUE_FIELD,
            REFERENCE,
            List.of(
                    PictureSetting.of(TECHNIQUE_FIELD, "stencil"),
                    PictureSetting.of(TECHNIQUE_FIELD, "texture", "a picture of its own"),
                    PictureSetting.of(TECHNIQUE_FIELD, "copy", "the whole frame buffer copied, for each view"),
                    PictureSetting.of(TECHNIQUE_FIELD, "copy_area", "the opening's part copied")));

    public static final Trade BUDGET = PictureSubjects.setting(
            "viewBudget",
            REFERENCE,
            Stream.concat(
                            Stream.of(PictureSetting.of("viewBudget", 0, "openings stay closed")),
                            PictureSetting.all("viewBudget", 1, 2, 3, 6, 9, 12, 32).stream())
                    .toList());

    public static final Trade BUDGET_BETWEEN_FACING = BUDGET.in(
            "levels/samples/facing-portals.json",
            "viewBudgetFacing",
            new Trade.Text(
                    "Views between facing portals",
                    "The same knob where it matters most: in the sample of two portals that face each other, which"
                            + " repeat until a view is smaller than a pixel.",
                    REFERENCE));

    public static final Trade RESOLUTION = PictureSubjects.of(
            RESOLUTION_FIELD,
            PictureSubjects.text(RESOLUTION_FIELD, REFERENCE),
            List.of(RESOLUTION_FIELD),
            "stencil",
            Stream.concat(
                            Stream.of("0.25", "0.5", "0.7", "1").map(PortalSubjects::resolution),
                            Stream.of(PictureSetting.of(TECHNIQUE_FIELD, "stencil")))
                    .toList());

    private PortalSubjects() {}

    private static PictureSetting resolution(String fraction) {
        return new PictureSetting(Setting.of(fraction), shot -> shot.set(TECHNIQUE_FIELD, "texture")
                .set(RESOLUTION_FIELD, fraction));
    }
}
