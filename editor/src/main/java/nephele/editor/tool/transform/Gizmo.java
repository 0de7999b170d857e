package nephele.editor.tool.transform;

import java.util.ArrayList;
import java.util.List;
import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.WorldAxis;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** The handles around a selection. Their size in the picture does not depend on the distance. */
enum Gizmo {
    MOVE,
    ROTATE,
    SCALE;

    /** The change that the drag of a grip makes. */
    enum Change {
        MOVE_ALONG,
        MOVE_IN_PLANE,
        TURN,
        SCALE_AXIS,
        SCALE_ALL
    }

    private static final double ARM_PIXELS = 80;
    private static final double PLANE_PIXELS = 28;
    private static final int RING_SIDES = 48;

    /**
     * A part of a gizmo that the pointer can take.
     *
     * @param name the same for the same part while the gizmo's size changes
     * @param at its handle, metres; {@code null} for a part without one
     * @param line its line, point after point; a closed one repeats its first point
     * @param origin the fixed place of a drag: of the axis, the plane, the turn or the scaling
     * @param direction along the axis, normal of the plane, axis of the turn, or from the origin to the handle
     */
    record Grip(String name, Vec3 at, List<Vec3> line, MarkColour colour, Change change, Vec3 origin, Vec3 direction) {
        private static final double LEAST_SINE = 0.05;

        /** Returns true if the pointer can drag it in a plan with this direction of sight: neither end on nor edge on. */
        boolean isUsable(Vec3 forward) {
            boolean isAcross = change == Change.MOVE_IN_PLANE || change == Change.TURN;
            double usableLength = isAcross
                    ? Math.abs(direction.dot(forward))
                    : direction.cross(forward).length();
            return usableLength > LEAST_SINE * direction.length();
        }

        /** Returns the distance of the pointer in pixels. */
        double pixelsFrom(Pointer pointer) {
            double least = at == null ? Double.POSITIVE_INFINITY : pointer.pixelsTo(at);
            for (int i = 1; i < line.size(); i++) {
                least = Math.min(least, pointer.pixelsTo(line.get(i - 1), line.get(i)));
            }
            return least;
        }

        List<Mark> marks(boolean isHovered) {
            MarkColour drawn = isHovered ? MarkColour.HOVERED : colour;
            List<Mark> marks = new ArrayList<>();
            for (int i = 1; i < line.size(); i++) {
                marks.add(new Mark.Line(line.get(i - 1), line.get(i), drawn, Mark.Visibility.ALWAYS));
            }
            if (at != null) {
                marks.add(new Mark.Handle(at, drawn));
            }
            return marks;
        }
    }

    /** Returns the grips around a box that is not empty. */
    List<Grip> grips(Aabb bounds, double metresPerPixel) {
        List<Grip> grips = new ArrayList<>();
        if (this == SCALE) {
            addScaling(grips, bounds);
            return grips;
        }
        Vec3 centre = bounds.centre();
        double arm = ARM_PIXELS * metresPerPixel;
        for (WorldAxis axis : WorldAxis.values()) {
            if (this == ROTATE) {
                grips.add(new Grip(
                        "turn " + axis,
                        null,
                        ring(centre, axis, arm),
                        axis.colour(),
                        Change.TURN,
                        centre,
                        axis.unit()));
            } else {
                Vec3 end = centre.addScaled(arm, axis.unit());
                List<Vec3> line = List.of(centre, end);
                grips.add(new Grip("move " + axis, end, line, axis.colour(), Change.MOVE_ALONG, centre, axis.unit()));
                grips.add(plane(centre, axis, metresPerPixel));
            }
        }
        return grips;
    }

    private static void addScaling(List<Grip> grips, Aabb bounds) {
        Vec3 half = bounds.centre().minus(new Vec3(bounds.minX(), bounds.minY(), bounds.minZ()));
        for (int side = 0; side < 27; side++) {
            Vec3 sign = new Vec3(side % 3 - 1, side / 3 % 3 - 1, side / 9 - 1);
            Vec3 by = sign.times(half);
            if (sign.dot(sign) == 1 && by.length() > 0) {
                WorldAxis axis = WorldAxis.nearest(sign);
                grips.add(handle("side " + side, Change.SCALE_AXIS, bounds.centre(), by, axis.colour()));
            } else if (sign.dot(sign) == 3) {
                grips.add(handle("corner " + side, Change.SCALE_ALL, bounds.centre(), by, MarkColour.SELECTED));
            }
        }
    }

    private static Grip handle(String name, Change change, Vec3 centre, Vec3 by, MarkColour colour) {
        return new Grip(name, centre.plus(by), List.of(), colour, change, centre.minus(by), by.scaled(2));
    }

    private static Grip plane(Vec3 centre, WorldAxis normal, double metresPerPixel) {
        WorldAxis first = next(normal);
        WorldAxis second = next(first);
        double side = PLANE_PIXELS * metresPerPixel;
        Vec3 corner = centre.addScaled(side, first.unit()).addScaled(side, second.unit());
        List<Vec3> line = List.of(centre.addScaled(side, first.unit()), corner, centre.addScaled(side, second.unit()));
        return new Grip("plane " + normal, corner, line, normal.colour(), Change.MOVE_IN_PLANE, centre, normal.unit());
    }

    private static List<Vec3> ring(Vec3 centre, WorldAxis axis, double radius) {
        Vec3 first = next(axis).unit();
        Vec3 second = next(next(axis)).unit();
        List<Vec3> ring = new ArrayList<>();
        for (int i = 0; i <= RING_SIDES; i++) {
            double angle = 2 * Math.PI * i / RING_SIDES;
            ring.add(centre.addScaled(radius * Math.cos(angle), first).addScaled(radius * Math.sin(angle), second));
        }
        return ring;
    }

    private static WorldAxis next(WorldAxis axis) {
        return WorldAxis.values()[(axis.ordinal() + 1) % 3];
    }
}
