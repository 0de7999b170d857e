package nephele.editor.pane;

import java.util.ArrayList;
import java.util.List;
import nephele.editor.pane.Mark.Visibility;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** Makes the lines around polygons and boxes. */
public final class MarkOutline {
    private MarkOutline() {}

    /** Returns the sides of a polygon. */
    public static List<Mark> polygon(List<Vec3> corners, MarkColour colour, Visibility visibility) {
        List<Mark> lines = new ArrayList<>();
        for (int i = 0; i < corners.size(); i++) {
            lines.add(new Mark.Line(corners.get(i), corners.get((i + 1) % corners.size()), colour, visibility));
        }
        return lines;
    }

    /** Returns the twelve edges of a box. */
    public static List<Mark> box(Aabb box, MarkColour colour, Visibility visibility) {
        List<Mark> lines = new ArrayList<>();
        for (int from = 0; from < 8; from++) {
            for (int axis = 1; axis < 8; axis *= 2) {
                if ((from & axis) == 0) {
                    lines.add(new Mark.Line(box.corner(from), box.corner(from | axis), colour, visibility));
                }
            }
        }
        return lines;
    }
}
