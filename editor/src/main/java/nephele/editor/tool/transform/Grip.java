package nephele.editor.tool.transform;

import java.util.ArrayList;
import java.util.List;
import nephele.editor.mark.Mark;
import nephele.editor.mark.MarkColour;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.ScreenDistance;
import nephele.engine.math.Vec3;

/**
 * A part of a gizmo that the pointer can take.
 *
 * @param name the same for the same part while the gizmo's size changes
 * @param at its handle, metres; {@code null} for a part without one
 * @param line its line, point after point; a closed one repeats its first point
 * @param constraint what a drag of it changes
 */
record Grip(String name, Vec3 at, List<Vec3> line, MarkColour colour, Constraint constraint) {
    /**
     * The place and the direction in which a drag works.
     *
     * @param origin the fixed place: of the axis, the plane, the turn or the scaling
     * @param direction along the axis, normal of the plane, axis of the turn, or from the origin to the handle
     */
    record Constraint(Kind kind, Vec3 origin, Vec3 direction) {
        private static final double LEAST_SINE = 0.05;

        /** Returns true if the pointer can drag it in a plan with this direction of sight: neither end on nor edge on. */
        boolean isUsable(Vec3 forward) {
            double cosine = Math.abs(direction.dot(forward)) / direction.length();
            return switch (kind) {
                case MOVE_IN_PLANE, TURN -> cosine > LEAST_SINE;
                case MOVE_ALONG, SCALE_AXIS, SCALE_ALL ->
                    direction.cross(forward).length() > LEAST_SINE * direction.length();
            };
        }
    }

    /** The transform that a grip makes. */
    enum Kind {
        MOVE_ALONG,
        MOVE_IN_PLANE,
        TURN,
        SCALE_AXIS,
        SCALE_ALL
    }

    /** Returns the distance of the pointer in pixels. */
    double pixelsFrom(Pointer pointer) {
        double least = at == null ? Double.POSITIVE_INFINITY : ScreenDistance.toPoint(pointer, at);
        for (int i = 1; i < line.size(); i++) {
            least = Math.min(least, ScreenDistance.toSegment(pointer, line.get(i - 1), line.get(i)));
        }
        return least;
    }

    List<Mark> marks(boolean isHovered) {
        MarkColour shown = isHovered ? MarkColour.HOVERED : colour;
        List<Mark> marks = new ArrayList<>();
        for (int i = 1; i < line.size(); i++) {
            marks.add(new Mark.Line(line.get(i - 1), line.get(i), shown, Mark.Visibility.ALWAYS));
        }
        if (at != null) {
            marks.add(new Mark.Handle(at, shown));
        }
        return marks;
    }
}
