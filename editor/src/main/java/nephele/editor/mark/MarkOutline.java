package nephele.editor.mark;

import java.util.ArrayList;
import java.util.List;
import nephele.editor.mark.Mark.Visibility;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** Makes the lines around polygons and boxes; they are never hidden. */
public final class MarkOutline {
    private MarkOutline() {}

    /** Returns the sides of a polygon. */
    public static List<Mark> polygon(List<Vec3> corners, MarkColour colour) {
        List<Mark> lines = new ArrayList<>();
        for (int i = 0; i < corners.size(); i++) {
            lines.add(line(corners.get(i), corners.get((i + 1) % corners.size()), colour));
        }
        return lines;
    }

    /** Returns the twelve edges of a box. */
    public static List<Mark> box(Aabb box, MarkColour colour) {
        List<Mark> lines = new ArrayList<>();
        for (int from = 0; from < 8; from++) {
            for (int axis = 1; axis < 8; axis *= 2) {
                if ((from & axis) == 0) {
                    lines.add(line(corner(box, from), corner(box, from | axis), colour));
                }
            }
        }
        return lines;
    }

    /** Returns a corner by bits: 1 for greater x, 2 for greater y, 4 for greater z. */
    private static Vec3 corner(Aabb box, int bits) {
        return new Vec3(
                (bits & 1) == 0 ? box.minX() : box.maxX(),
                (bits & 2) == 0 ? box.minY() : box.maxY(),
                (bits & 4) == 0 ? box.minZ() : box.maxZ());
    }

    private static Mark line(Vec3 from, Vec3 to, MarkColour colour) {
        return new Mark.Line(from, to, colour, Visibility.ALWAYS);
    }
}
