package nephele.editor.tool.transform;

import java.util.ArrayList;
import java.util.List;
import nephele.editor.mark.MarkColour;
import nephele.editor.tool.WorldAxis;
import nephele.editor.tool.transform.Grip.Constraint;
import nephele.editor.tool.transform.Grip.Kind;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** The grips around a selection. Their size in the picture does not depend on the distance. */
enum Gizmo {
    MOVE {
        @Override
        List<Grip> grips(Aabb bounds, double metresPerPixel) {
            List<Grip> grips = new ArrayList<>();
            Vec3 centre = bounds.centre();
            for (WorldAxis axis : WorldAxis.values()) {
                Vec3 end = centre.addScaled(ARM_PIXELS * metresPerPixel, axis.unit());
                grips.add(new Grip(
                        "move " + axis,
                        end,
                        List.of(centre, end),
                        axis.colour(),
                        new Constraint(Kind.MOVE_ALONG, centre, axis.unit())));
                grips.add(plane(centre, axis, metresPerPixel));
            }
            return grips;
        }
    },
    ROTATE {
        @Override
        List<Grip> grips(Aabb bounds, double metresPerPixel) {
            List<Grip> grips = new ArrayList<>();
            Vec3 centre = bounds.centre();
            for (WorldAxis axis : WorldAxis.values()) {
                grips.add(new Grip(
                        "turn " + axis,
                        null,
                        ring(centre, axis, ARM_PIXELS * metresPerPixel),
                        axis.colour(),
                        new Constraint(Kind.TURN, centre, axis.unit())));
            }
            return grips;
        }
    },
    SCALE {
        @Override
        List<Grip> grips(Aabb bounds, double metresPerPixel) {
            List<Grip> grips = new ArrayList<>();
            Vec3 half = bounds.centre().minus(new Vec3(bounds.minX(), bounds.minY(), bounds.minZ()));
            for (int side = 0; side < 27; side++) {
                Vec3 sign = new Vec3(side % 3 - 1, side / 3 % 3 - 1, side / 9 - 1);
                Vec3 by = sign.times(half);
                if (sign.dot(sign) == 1 && by.length() > 0) {
                    WorldAxis axis = WorldAxis.nearest(sign);
                    grips.add(handle("side " + side, Kind.SCALE_AXIS, bounds.centre(), by, axis.colour()));
                } else if (sign.dot(sign) == 3) {
                    grips.add(handle("corner " + side, Kind.SCALE_ALL, bounds.centre(), by, MarkColour.SELECTED));
                }
            }
            return grips;
        }
    };

    private static final double ARM_PIXELS = 80;
    private static final double PLANE_PIXELS = 28;
    private static final int RING_SIDES = 48;

    /** Returns the grips around a box that is not empty. */
    abstract List<Grip> grips(Aabb bounds, double metresPerPixel);

    private static Grip plane(Vec3 centre, WorldAxis normal, double metresPerPixel) {
        WorldAxis first = next(normal);
        WorldAxis second = next(first);
        double side = PLANE_PIXELS * metresPerPixel;
        Vec3 corner = centre.addScaled(side, first.unit()).addScaled(side, second.unit());
        return new Grip(
                "plane " + normal,
                corner,
                List.of(centre.addScaled(side, first.unit()), corner, centre.addScaled(side, second.unit())),
                normal.colour(),
                new Constraint(Kind.MOVE_IN_PLANE, centre, normal.unit()));
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

    private static Grip handle(String name, Kind kind, Vec3 centre, Vec3 by, MarkColour colour) {
        Vec3 opposite = centre.minus(by);
        return new Grip(name, centre.plus(by), List.of(), colour, new Constraint(kind, opposite, by.scaled(2)));
    }

    private static WorldAxis next(WorldAxis axis) {
        return WorldAxis.values()[(axis.ordinal() + 1) % 3];
    }
}
