package nephele.editor.draw;

import java.util.List;
import nephele.editor.pane.MarkColour;
import nephele.engine.asset.Picture;

/**
 * The lower right corner of a pane, above its picture: a legend of colours, and a small picture.
 *
 * @param picture {@code null} for none
 * @param caption of the picture
 */
public record PaneInset(List<LegendLine> legend, Picture picture, String caption) {
    public static final PaneInset NONE = new PaneInset(List.of(), null, "");

    /** The pattern of lines on an area, as the marks of the map have it. */
    public enum Pattern {
        PLAIN,
        SLANTED,
        CROSSED
    }

    /** A colour and its meaning. */
    public record LegendLine(MarkColour colour, Pattern pattern, String text) {}

    public PaneInset {
        legend = List.copyOf(legend);
    }
}
