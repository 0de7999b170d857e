package nephele.editor.proving;

import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.engine.math.Vec3;

/**
 * A piece of surface with the result of a shot straight at it.
 *
 * @param mark the piece, coloured: ALLOWED where a portal fits as aimed, SLIDES or REFUSED
 * @param aim the aimed point, on the surface
 * @param text the result
 * @param metres how far the portal slides or how uneven the ground is, if that is the result, otherwise 0
 */
public record HeatCell(Mark.Polygon mark, Vec3 aim, HeatText text, double metres) {
    /** Returns the result as a colour. */
    public MarkColour colour() {
        return mark.colour();
    }
}
