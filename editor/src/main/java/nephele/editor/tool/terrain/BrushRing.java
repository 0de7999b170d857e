package nephele.editor.tool.terrain;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import nephele.editor.mark.Mark;
import nephele.editor.mark.Mark.Visibility;
import nephele.editor.mark.MarkColour;
import nephele.engine.math.Vec3;

/** The outline of a round brush on the ground, and its middle. */
final class BrushRing {
    private static final int CORNERS = 64;
    /** The outline is so far above the ground that this does not hide it. */
    private static final double LIFT_PER_RADIUS = 0.01;

    private BrushRing() {}

    /**
     * Returns the marks of a brush; parts beside the terrain are left out.
     *
     * @param y the ground's world y at x and z; NaN beside it
     */
    static List<Mark> around(double x, double z, double radius, DoubleBinaryOperator y) {
        List<Mark> marks = new ArrayList<>();
        Vec3 previous = corner(x, z, radius, 0, y);
        for (int i = 1; i <= CORNERS; i++) {
            Vec3 next = corner(x, z, radius, i, y);
            if (!Double.isNaN(previous.y() + next.y())) {
                marks.add(new Mark.Line(previous, next, MarkColour.PREVIEW, Visibility.ALWAYS));
            }
            previous = next;
        }
        marks.add(new Mark.Handle(new Vec3(x, y.applyAsDouble(x, z), z), MarkColour.PREVIEW));
        return marks;
    }

    private static Vec3 corner(double middleX, double middleZ, double radius, int number, DoubleBinaryOperator y) {
        double angle = 2 * Math.PI * number / CORNERS;
        double x = middleX + radius * Math.cos(angle);
        double z = middleZ + radius * Math.sin(angle);
        return new Vec3(x, y.applyAsDouble(x, z) + LIFT_PER_RADIUS * radius, z);
    }
}
