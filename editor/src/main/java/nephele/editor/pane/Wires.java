package nephele.editor.pane;

import java.util.List;
import nephele.editor.pane.Mark.Visibility;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** Collects the lines of one symbol in one colour. */
record Wires(List<Mark> marks, MarkColour colour, Visibility visibility) {
    private static final int CIRCLE_SEGMENTS = 48;
    private static final Vec3 X = new Vec3(1, 0, 0);
    private static final Vec3 Y = new Vec3(0, 1, 0);
    private static final Vec3 Z = new Vec3(0, 0, 1);

    void line(Vec3 from, Vec3 to) {
        marks.add(new Mark.Line(from, to, colour, visibility));
    }

    void label(Vec3 at, String text) {
        marks.add(new Mark.Label(at, text, colour));
    }

    /** Adds a closed polygon. */
    void outline(List<Vec3> corners) {
        marks.addAll(Mark.polygon(corners, colour, visibility));
    }

    /** Adds a circle; both axes have the radius as length. */
    void circle(Vec3 centre, Vec3 axis, Vec3 other) {
        arc(centre, axis, other, 360);
    }

    /** Adds an arc from the end of one axis over the other one. */
    void arc(Vec3 centre, Vec3 axis, Vec3 other, double degrees) {
        int segments = (int) Math.ceil(CIRCLE_SEGMENTS * degrees / 360);
        Vec3 last = centre.plus(axis);
        for (int i = 1; i <= segments; i++) {
            double angle = Math.toRadians(degrees * i / segments);
            Vec3 next = centre.addScaled(Math.cos(angle), axis).addScaled(Math.sin(angle), other);
            line(last, next);
            last = next;
        }
    }

    /** Adds three circles around the axes of the world. */
    void sphere(Vec3 centre, double radius) {
        circle(centre, X.scaled(radius), Y.scaled(radius));
        circle(centre, Y.scaled(radius), Z.scaled(radius));
        circle(centre, Z.scaled(radius), X.scaled(radius));
    }

    /** Adds an upright cylinder. */
    void cylinder(Vec3 feet, double radius, double height) {
        Vec3 top = feet.addScaled(height, Y);
        circle(feet, X.scaled(radius), Z.scaled(radius));
        circle(top, X.scaled(radius), Z.scaled(radius));
        for (Vec3 side : List.of(X, Z, X.negated(), Z.negated())) {
            line(feet.addScaled(radius, side), top.addScaled(radius, side));
        }
    }

    /** Adds an upright capsule; its height includes both caps. */
    void capsule(Vec3 feet, double radius, double height) {
        Vec3 lower = feet.addScaled(radius, Y);
        Vec3 upper = feet.addScaled(height - radius, Y);
        circle(lower, X.scaled(radius), Z.scaled(radius));
        circle(upper, X.scaled(radius), Z.scaled(radius));
        for (Vec3 side : List.of(X, Z)) {
            Vec3 out = side.scaled(radius);
            line(lower.plus(out), upper.plus(out));
            line(lower.minus(out), upper.minus(out));
            arc(upper, out, Y.scaled(radius), 180);
            arc(lower, out, Y.scaled(-radius), 180);
        }
    }

    /** Adds the edges of a box. */
    void box(Aabb box) {
        marks.addAll(Mark.box(box, colour, visibility));
    }

    /** Adds an arrow; {@code aside} has unit length and is perpendicular to it. */
    void arrow(Vec3 from, Vec3 to, Vec3 aside) {
        line(from, to);
        Vec3 back = from.minus(to).scaled(0.25);
        double width = back.length() * 0.6;
        line(to, to.plus(back).addScaled(width, aside));
        line(to, to.plus(back).addScaled(-width, aside));
    }
}
