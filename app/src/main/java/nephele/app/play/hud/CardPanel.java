package nephele.app.play.hud;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.render.pass.overlay.OverlayCanvas;

/**
 * Draws the card of the selected entry beside the menu: a picture, facts, then a text, which is smaller and in the end cut
 * where there is no room. Lengths are in points.
 */
final class CardPanel {
    static final double WIDTH = 384;
    private static final double PADDING = 20;
    private static final double FACT_HEIGHT = 30;
    private static final double FACT_EM = 18;
    private static final double TEXT_EM = 18;
    private static final double LEAST_EM = 14;
    private static final double LINE_EMS = 1.35;
    private static final double GAP = 10;
    private static final double AIM_COLUMN = 118;
    private static final String CUT = " …";

    private final Menu.Card card;
    private final double scale;

    /** @param scale that of the menu */
    CardPanel(Menu.Card card, double scale) {
        this.card = card;
        this.scale = scale;
    }

    /** @param room the height below the upper edge */
    void draw(OverlayCanvas canvas, double x, double top, double room) {
        double pictureHeight = card.picture() == null
                ? 0
                : WIDTH * card.picture().height() / card.picture().width();
        double factsHeight = card.facts().size() * FACT_HEIGHT;
        TextLines text = fitting(canvas, room / scale - 3 - pictureHeight - factsHeight - 2 * PADDING);
        double textHeight = text.lines().size() * text.em() * LINE_EMS;
        double between = factsHeight > 0 && textHeight > 0 ? GAP : 0;
        double below = factsHeight + between + textHeight;
        double panel = below > 0 ? below + 2 * PADDING : 0;
        canvas.rectangle(x, top, scale * WIDTH, 3, HudPalette.ACCENT);
        canvas.rectangle(x, top + 3 + scale * pictureHeight, scale * WIDTH, scale * panel, HudPalette.PANEL);
        if (card.picture() != null) {
            canvas.picture(x, top + 3, scale * WIDTH, scale * pictureHeight, card.picture());
        }
        double y = top + 3 + scale * (pictureHeight + PADDING);
        for (Menu.Fact fact : card.facts()) {
            drawFact(canvas, x, y + scale * (FACT_HEIGHT / 2 + 0.35 * FACT_EM - GAP / 2), fact);
            y += scale * FACT_HEIGHT;
        }
        y += scale * between;
        for (String line : text.lines()) {
            canvas.text(x + scale * PADDING, y + scale * text.em(), scale * text.em(), HudPalette.INK, line);
            y += scale * text.em() * LINE_EMS;
        }
    }

    /** Draws a fact; a value that does not fit beside its name is smaller. */
    private void drawFact(OverlayCanvas canvas, double x, double baseline, Menu.Fact fact) {
        double end = canvas.text(x + scale * PADDING, baseline, scale * FACT_EM, HudPalette.QUIET_INK, fact.name());
        double right = x + scale * (WIDTH - PADDING);
        if (!fact.aim().isEmpty()) {
            double width = canvas.width(scale * FACT_EM, fact.aim());
            canvas.text(right - width, baseline, scale * FACT_EM, HudPalette.ACCENT, fact.aim());
            right -= Math.max(scale * AIM_COLUMN, width + scale * GAP);
        }
        double width = canvas.width(scale * FACT_EM, fact.value());
        double room = right - end - scale * GAP;
        double em = scale * FACT_EM * Math.min(1, room / width);
        canvas.text(right - Math.min(width, room), baseline, em, HudPalette.INK, fact.value());
    }

    /** Returns the text in the largest letters that fit; cut if even the smallest do not. */
    private TextLines fitting(OverlayCanvas canvas, double height) {
        if (card.text().isEmpty()) {
            return new TextLines(TEXT_EM, List.of());
        }
        for (double em = TEXT_EM; ; em -= 1) {
            List<String> lines = new ArrayList<>();
            for (String paragraph : card.text().split("\n")) {
                lines.addAll(TextLines.broken(canvas, em, WIDTH - 2 * PADDING, paragraph));
            }
            int most = Math.max(1, (int) (height / (em * LINE_EMS)));
            if (lines.size() <= most) {
                return new TextLines(em, lines);
            }
            if (em <= LEAST_EM) {
                List<String> cut = new ArrayList<>(lines.subList(0, most));
                String last = cut.get(most - 1);
                cut.set(most - 1, last.substring(0, Math.max(0, last.length() - CUT.length())) + CUT);
                return new TextLines(em, cut);
            }
        }
    }
}
