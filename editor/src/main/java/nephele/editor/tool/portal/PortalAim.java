package nephele.editor.tool.portal;

import java.util.ArrayList;
import java.util.List;
import nephele.editor.heat.HeatText;
import nephele.editor.mark.Mark;
import nephele.editor.mark.MarkColour;
import nephele.editor.mark.MarkOutline;
import nephele.editor.text.Words;
import nephele.engine.portal.Portal;
import nephele.engine.portal.placement.PlacementResult;

/** The result of a shot in marks and words. */
record PortalAim(PlacementResult result) {
    /** Slide up to which a portal is where it was aimed. */
    private static final double AIMED_METRES = 1e-6;

    List<Mark> marks() {
        return result instanceof PlacementResult.Fits fits
                ? outline(fits.portal(), isSliding(fits) ? MarkColour.SLIDES : MarkColour.ALLOWED)
                : List.of(new Mark.Handle(((PlacementResult.Refused) result).where(), MarkColour.REFUSED));
    }

    /** Returns the border of a portal, with a line in the direction in which it faces. */
    static List<Mark> outline(Portal portal, MarkColour colour) {
        List<Mark> marks = new ArrayList<>(MarkOutline.polygon(portal.corners(), colour, Mark.Visibility.ALWAYS));
        marks.add(new Mark.Line(portal.centre(), portal.world(0, 0, 0.3), colour, Mark.Visibility.ALWAYS));
        return marks;
    }

    Words words() {
        if (result instanceof PlacementResult.Fits fits) {
            return (isSliding(fits) ? HeatText.SLIDES : HeatText.FITS).words(fits.slideMetres());
        }
        PlacementResult.Refused refused = (PlacementResult.Refused) result;
        return HeatText.of(refused.reason()).words(refused.unevenMetres());
    }

    private static boolean isSliding(PlacementResult.Fits fits) {
        return fits.slideMetres() > AIMED_METRES;
    }
}
