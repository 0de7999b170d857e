package nephele.workshop.prove.picture;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Compares drawn pictures in identity colours with traced ones. A pixel is wrong if the twin shows one surface in all
 * of the three by three pixels around it and the drawn surface is another, unless some ray within one pixel hits that:
 * objects thinner than a pixel may be hit or missed, and of coincident faces any may be visible. A pixel beside an edge
 * is not judged, but counted if it shows a surface that is not there: a crack, or a portal that is a pixel too wide.
 */
final class IdTally {
    /** The colour of an opening that the view budget does not reach. */
    static final int TERMINAL = 0xff00ff;

    private final List<String> failures = new ArrayList<>();
    private long pixels;
    private long atEdges;
    private long beyondEdges;
    private long beyondBudget;
    private long wrong;
    private double largestTerminalFraction;

    /**
     * Compares a picture.
     *
     * @param viewBudget the number of views through portals that the picture may have: {@link ComparedLevel#UNLIMITED} if
     *     none may be missing, else missing ones are counted, not judged
     * @param what names the picture and the way to draw it again
     */
    void compare(BufferedImage drawn, SightPicture traced, int viewBudget, String what) {
        int bad = 0;
        int missing = 0;
        String first = "";
        for (int i = 0; i < drawn.getWidth() * drawn.getHeight(); i++) {
            int column = i % drawn.getWidth();
            int row = i / drawn.getWidth();
            int colour = drawn.getRGB(column, drawn.getHeight() - 1 - row) & 0xffffff;
            if (colour == TERMINAL) {
                missing++;
            } else if (colour != traced.at(column, row)) {
                boolean isEdge = !traced.isPlain(column, row);
                boolean isThere = traced.shows(colour, column, row);
                atEdges += isEdge ? 1 : 0;
                beyondEdges += isEdge && !isThere ? 1 : 0;
                if (!isEdge && !isThere) {
                    first = bad++ == 0 ? example(colour, traced, column, drawn.getHeight() - 1 - row) : first;
                }
            }
        }
        int all = drawn.getWidth() * drawn.getHeight();
        pixels += all;
        wrong += bad;
        if (viewBudget < ComparedLevel.UNLIMITED) {
            beyondBudget += missing;
            largestTerminalFraction = Math.max(largestTerminalFraction, (double) missing / all);
        } else if (missing > 0) {
            wrong += missing;
            failures.add(String.format(Locale.ROOT, "%s: %d pixels of views that were not drawn", what, missing));
        }
        if (bad > 0) {
            failures.add(String.format(Locale.ROOT, "%s: %d pixels show another surface, first %s", what, bad, first));
        }
    }

    private static String example(int colour, SightPicture traced, int column, int rowFromTop) {
        int rowFromBottom = traced.height() - 1 - rowFromTop;
        return String.format(
                Locale.ROOT,
                "(%d, %d): %06x instead of %06x",
                column,
                rowFromTop,
                colour,
                traced.at(column, rowFromBottom));
    }

    ProofResult result(long units) {
        return ProofResult.of(
                units,
                failures,
                Figure.sum("pixels", pixels, ""),
                Figure.sum("pixels that show another surface", wrong, ""),
                Figure.sum("pixels beside an edge that show something else than in their middle", atEdges, ""),
                Figure.sum("of those, what no ray within a pixel meets", beyondEdges, ""),
                Figure.sum("pixels of views beyond the default budget", beyondBudget, ""),
                Figure.greatest("largest share of them in a picture", 100 * largestTerminalFraction, "%"));
    }
}
