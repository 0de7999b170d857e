package nephele.editor.window.viewport;

import java.util.ArrayList;
import java.util.List;
import nephele.editor.draw.PaneInset;
import nephele.editor.draw.PaneInset.LegendLine;
import nephele.editor.draw.PaneInset.Pattern;
import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PaneLayout.PaneRectangle;
import nephele.editor.pane.PaneView;
import nephele.editor.proving.HeatOverlay;
import nephele.editor.proving.HeatText;
import nephele.editor.proving.ProvingText;
import nephele.editor.proving.TracedCorner.Traced;
import nephele.editor.session.EditorSession;
import nephele.engine.level.Language;

/** The results of a session's proofs in perspective panes: the heat map with its legend, and the traced picture. */
final class ProvingInset {
    private ProvingInset() {}

    static List<Mark> marks(EditorSession session, PaneView view) {
        return view.kind() == PaneKind.PERSPECTIVE ? session.proving().heat().marks() : List.of();
    }

    static PaneInset of(EditorSession session, PaneRectangle place) {
        PaneView view = session.panes().views().get(place.index());
        if (view.kind() != PaneKind.PERSPECTIVE) {
            return PaneInset.NONE;
        }
        Language language = session.language();
        Traced traced = session.proving().corner().traced(place.index()).orElse(null);
        String caption = traced == null
                ? ""
                : traced.samples() == 0
                        ? ProvingText.TRACING.in(language)
                        : ProvingText.TRACED.in(language, traced.samples());
        return new PaneInset(
                legend(session.proving().heat(), language), traced == null ? null : traced.picture(), caption);
    }

    private static List<LegendLine> legend(HeatOverlay heat, Language language) {
        if (!heat.isShown()) {
            return List.of();
        }
        List<LegendLine> lines = new ArrayList<>();
        heat.counts().forEach((text, count) -> lines.add(line(text, count, language)));
        return lines;
    }

    private static LegendLine line(HeatText text, int count, Language language) {
        String words = count + "  " + text.legend().in(language);
        return switch (text) {
            case FITS -> new LegendLine(MarkColour.ALLOWED, Pattern.PLAIN, words);
            case SLIDES -> new LegendLine(MarkColour.SLIDES, Pattern.SLANTED, words);
            case NOTHING_HIT,
                    OUT_OF_RANGE,
                    MOVING_SURFACE,
                    NOT_PORTALABLE,
                    NOT_FLAT,
                    OVERLAPS_OTHER,
                    TOO_SMALL,
                    EDGE,
                    OCCUPIED -> new LegendLine(MarkColour.REFUSED, Pattern.CROSSED, words);
        };
    }
}
