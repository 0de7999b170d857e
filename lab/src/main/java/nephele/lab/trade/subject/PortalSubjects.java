package nephele.lab.trade.subject;

import java.util.List;
import java.util.stream.Stream;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;

/** Quality fields {@code portalTechnique}, {@code viewBudget} and {@code portalResolution}. */
public final class PortalSubjects {
    private static final String TECHNIQUE_FIELD = "portalTechnique";
    private static final String BUDGET_FIELD = "viewBudget";
    private static final String RESOLUTION_FIELD = "portalResolution";
    private static final String ORACLE = "the oracle: rays go through portals without a limit that shows";

    public static final Trade TECHNIQUE = PictureSubjects.of(
            TECHNIQUE_FIELD,
            new Trade.Text(
                    "How portals are drawn",
                    "What is behind a portal is drawn straight into the picture where a stencil allows it, or into a"
                        + " texture that then covers the opening. The source also weighed to draw it into the frame"
                        + " buffer, to copy that out and to draw the rest over it; copying only the opening's part is"
                        + " the last setting.",
                    ORACLE),
            List.of(TECHNIQUE_FIELD),
            "stencil",
            List.of(
                    technique("stencil", "all presets"),
                    technique("texture", "a picture of its own"),
                    technique("copy", "the whole frame buffer copied, for each view"),
                    technique("copy_area", "the opening's part copied")));

    public static final Trade BUDGET = PictureSubjects.of(
            BUDGET_FIELD,
            new Trade.Text(
                    "Views through portals",
                    "So many views through portals are drawn in a frame at most, the largest ones. In openings beyond"
                            + " the budget the previous picture is shown, moved to where it fits; before there is one,"
                            + " the sky there behind the portal's membrane.",
                    ORACLE),
            List.of(BUDGET_FIELD),
            "12",
            Stream.of(0, 1, 2, 3, 6, 9, 12, 32)
                    .map(views -> PictureSetting.of(BUDGET_FIELD, views, budgetNote(views)))
                    .toList());

    public static final Trade BUDGET_BETWEEN_FACING = BUDGET.in(
            "levels/samples/facing-portals.json",
            "viewBudgetFacing",
            new Trade.Text(
                    "Views between facing portals",
                    "The same knob where it matters most: in the sample of two portals that face each other, which"
                            + " repeat until a view is smaller than a pixel.",
                    ORACLE));

    public static final Trade RESOLUTION = PictureSubjects.of(
            RESOLUTION_FIELD,
            new Trade.Text(
                    "Resolution of portal pictures",
                    "Of the texture technique: how many pixels a portal's picture has along each side, as a share of"
                            + " the whole picture's. Stencil is shown beside it; it has no such knob.",
                    ORACLE),
            List.of(RESOLUTION_FIELD),
            "stencil",
            Stream.concat(
                            Stream.of("0.25", "0.5", "0.7", "1").map(PortalSubjects::resolution),
                            Stream.of(technique("stencil", "all presets")))
                    .toList());

    private PortalSubjects() {}

    private static PictureSetting technique(String word, String note) {
        return PictureSetting.of(TECHNIQUE_FIELD, word, note);
    }

    private static PictureSetting resolution(String share) {
        return new PictureSetting(
                Setting.of(share), shot -> shot.set(TECHNIQUE_FIELD, "texture").set(RESOLUTION_FIELD, share));
    }

    private static String budgetNote(int views) {
        return switch (views) {
            case 0 -> "openings stay closed";
            case 6 -> "low";
            case 9 -> "medium";
            case 12 -> "high";
            case 32 -> "ultra";
            default -> "";
        };
    }
}
