package nephele.editor.pane;

import java.util.ArrayList;
import java.util.List;
import nephele.editor.pane.Mark.Visibility;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** Something that the editor draws over the engine's picture; positions are in world metres. */
public sealed interface Mark {
    /** Selects whether surfaces of the level hide a mark behind them. */
    enum Visibility {
        HIDDEN_BY_SURFACES,
        ALWAYS
    }

    MarkColour colour();

    /** A line, one or two pixels wide. */
    record Line(Vec3 from, Vec3 to, MarkColour colour, Visibility visibility) implements Mark {}

    /** A thin line of a pattern on a surface, without an outline; surfaces hide it. */
    record Stroke(Vec3 from, Vec3 to, MarkColour colour) implements Mark {}

    /** A translucent convex polygon, seen from both sides; corners in order around it. */
    record Polygon(List<Vec3> corners, MarkColour colour, Visibility visibility) implements Mark {}

    /** A square handle whose size in pixels does not depend on the distance; never hidden. */
    record Handle(Vec3 at, MarkColour colour) implements Mark {}

    /** A line of text beside a point; never hidden. */
    record Label(Vec3 at, String text, MarkColour colour) implements Mark {}

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
