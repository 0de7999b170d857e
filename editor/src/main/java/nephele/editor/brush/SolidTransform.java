package nephele.editor.brush;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntUnaryOperator;
import java.util.function.UnaryOperator;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Solid;
import nephele.engine.level.Solid.PlaneFace;
import nephele.engine.level.appearance.SolidFaces;
import nephele.engine.math.Plane;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import org.joml.Quaterniond;

/**
 * Movement, rotation and scaling of solids. Positions on a grid of powers of two stay exact: a solid that is moved there
 * and back, or turned four times by 90°, is equal to the last bit.
 */
public final class SolidTransform {
    /** The two ends come before the sides among a prism's faces. */
    private static final int FIRST_SIDE = 2;

    private SolidTransform() {}

    /** Returns the solid moved; moving is never refused, even out of the world. */
    public static Solid moved(Solid solid, Vec3 by) {
        if (solid instanceof Solid.Planes planes) {
            return eachPlane(planes, face -> moved(face, by));
        } else if (solid instanceof Solid.Box box) {
            return placed(box, sum(box.centre(), by), box.size());
        } else if (solid instanceof Solid.Wedge wedge) {
            return placed(wedge, sum(wedge.centre(), by), wedge.size());
        }
        Solid.Prism prism = (Solid.Prism) solid;
        return placed(prism, sum(prism.centre(), by), prism.radiusMetres(), prism.heightMetres());
    }

    private static Vec3 sum(Vec3 centre, Vec3 by) {
        return ExactNumber.clean(centre.plus(by), ExactNumber.OF_SUMS);
    }

    private static PlaneFace moved(PlaneFace face, Vec3 by) {
        return shifted(face, face.normal(), along(face.normal(), by));
    }

    private static PlaneFace shifted(PlaneFace face, Vec3 normal, double shift) {
        double sum = face.distanceMetres() + shift;
        return withDistance(
                face, normal, PlaneForm.isAlongAxis(normal) ? ExactNumber.clean(sum, ExactNumber.OF_SUMS) : sum);
    }

    /** Returns the length of a vector along a normal; snapped for an oblique one, so that sums of it are exact. */
    private static double along(Vec3 normal, Vec3 v) {
        double length = Plane.of(normal, 0).normal().dot(v);
        return PlaneForm.isAlongAxis(normal) ? length : ExactNumber.snapped(length);
    }

    private static PlaneFace withDistance(PlaneFace face, Vec3 normal, double distance) {
        return PlaneForm.at(face, normal, distance + 0.0);
    }

    /**
     * Returns the solid turned around an axis through the pivot, counter-clockwise seen against the axis. Boxes, wedges
     * and prisms keep their kind where it can express the result.
     */
    public static BrushEdit<Solid> rotated(Solid solid, Vec3 pivot, Vec3 axis, double degrees) {
        QuarterTurn quarters = QuarterTurn.of(axis, degrees);
        if (quarters != null) {
            return BrushCheck.checked(quarterTurned(solid, pivot, quarters));
        }
        Quaterniond rotation = Rotations.aroundAxis(axis, Math.toRadians(degrees));
        UnaryOperator<Vec3> turn = v -> Vec3.of(rotation.transform(v.toVector()));
        return PlaneForm.rebuilt(eachPlane(PlaneForm.of(solid), face -> rotated(face, pivot, turn)));
    }

    private static PlaneFace rotated(PlaneFace face, Vec3 pivot, UnaryOperator<Vec3> turn) {
        Plane before = PlaneForm.plane(face);
        Vec3 normal = Plane.of(turn.apply(before.normal()), 0).normal();
        PlaneFace turned = PlaneForm.canonical(
                new Plane(normal.x(), normal.y(), normal.z(), before.signedDistance(pivot) * -1 + normal.dot(pivot)));
        return withDistance(face, turned.normal(), turned.distanceMetres());
    }

    private static Solid quarterTurned(Solid solid, Vec3 pivot, QuarterTurn turn) {
        if (turn.turns() == 0) {
            return solid;
        } else if (solid instanceof Solid.Box box) {
            return placed(withFaces(box, turn::side), turn.point(box.centre(), pivot), turn.size(box.size()));
        } else if (solid instanceof Solid.Wedge wedge && turn.axis() == 1) {
            Solid.Wedge turned = withFaces(wedge, turn::side);
            BoxFace rising = turn.side(wedge.rising());
            return placed(turned, rising, turn.point(wedge.centre(), pivot), turn.size(wedge.size()));
        } else if (solid instanceof Solid.Prism prism && turn.axis() == 1 && prism.sides() * turn.turns() % 4 == 0) {
            Solid.Prism turned = turned(prism, turn.turns());
            return placed(turned, turn.point(prism.centre(), pivot), prism.radiusMetres(), prism.heightMetres());
        }
        Solid.Planes planes = solid instanceof Solid.Planes given ? given : PlaneForm.of(solid);
        return SimplestSolid.exceptBox(eachPlane(planes, face -> {
            Vec3 normal = turn.direction(face.normal());
            double shift = along(normal, pivot) - along(face.normal(), pivot);
            return shifted(face, normal, shift);
        }));
    }

    /** Returns the solid scaled from the pivot; negative factors mirror it. */
    public static BrushEdit<Solid> scaled(Solid solid, Vec3 pivot, Vec3 factors) {
        AxisScale scale = new AxisScale(factors, pivot);
        if (!(factors.x() * factors.y() * factors.z() != 0)) {
            return BrushEdit.refused(BrushText.FLAT);
        }
        if (solid instanceof Solid.Box box) {
            return BrushCheck.checked(
                    placed(withFaces(box, scale::side), scale.point(box.centre()), scale.size(box.size())));
        } else if (solid instanceof Solid.Wedge wedge && factors.y() > 0) {
            Solid.Wedge turned = withFaces(wedge, scale::side);
            BoxFace rising = scale.side(wedge.rising());
            return BrushCheck.checked(placed(turned, rising, scale.point(wedge.centre()), scale.size(wedge.size())));
        } else if (solid instanceof Solid.Prism prism && keepsRegular(prism, factors)) {
            Vec3 size = scale.size(new Vec3(prism.radiusMetres(), prism.heightMetres(), 0));
            Solid.Prism mirrored = mirrored(prism, factors);
            return BrushCheck.checked(placed(mirrored, scale.point(prism.centre()), size.x(), size.y()));
        }
        return PlaneForm.rebuilt(eachPlane(PlaneForm.of(solid), scale::plane));
    }

    /** A prism's side 0 faces +x, so that its mirror image along z is itself, that along x only with even sides. */
    private static boolean keepsRegular(Solid.Prism prism, Vec3 factors) {
        return Math.abs(factors.x()) == Math.abs(factors.z()) && (factors.x() > 0 || prism.sides() % 2 == 0);
    }

    private static Solid.Planes eachPlane(Solid.Planes solid, UnaryOperator<PlaneFace> change) {
        List<PlaneFace> faces = new ArrayList<>(solid.planes().size());
        solid.planes().forEach(face -> faces.add(change.apply(face)));
        return PlaneForm.with(solid, solid.id(), faces);
    }

    /** Returns the wedge with what it says of its sides said of the sides that they have turned to. */
    private static Solid.Wedge withFaces(Solid.Wedge wedge, UnaryOperator<BoxFace> turn) {
        Map<String, Solid.Face> faces = new LinkedHashMap<>();
        for (BoxFace side : BoxFace.values()) {
            if (wedge.faces().containsKey(side.text())) {
                faces.put(turn.apply(side).text(), wedge.faces().get(side.text()));
            }
        }
        if (wedge.faces().containsKey("slope")) {
            faces.put("slope", wedge.faces().get("slope"));
        }
        return wedge.withFaces(Collections.unmodifiableMap(faces));
    }

    /** Returns the box with what it says of its sides said of the sides that they have turned to. */
    private static Solid.Box withFaces(Solid.Box box, UnaryOperator<BoxFace> turn) {
        Map<BoxFace, Solid.Face> faces = new EnumMap<>(BoxFace.class);
        box.faces().forEach((side, face) -> faces.put(turn.apply(side), face));
        return box.withFaces(Collections.unmodifiableMap(faces));
    }

    static Solid.Box placed(Solid.Box b, Vec3 centre, Vec3 size) {
        return new Solid.Box(b.id(), b.material(), b.portalable(), b.textureMapping(), centre, size, b.faces());
    }

    static Solid.Wedge placed(Solid.Wedge w, Vec3 centre, Vec3 size) {
        return placed(w, w.rising(), centre, size);
    }

    private static Solid.Wedge placed(Solid.Wedge w, BoxFace rising, Vec3 centre, Vec3 size) {
        return new Solid.Wedge(
                w.id(), w.material(), w.portalable(), w.textureMapping(), centre, size, rising, w.faces());
    }

    static Solid.Prism placed(Solid.Prism p, Vec3 centre, double radius, double height) {
        return new Solid.Prism(
                p.id(), p.material(), p.portalable(), p.textureMapping(), centre, radius, height, p.sides(), p.faces());
    }

    /** Turns the sides by quarters about +y; their number times the quarters is a multiple of 4. */
    private static Solid.Prism turned(Solid.Prism prism, int quarters) {
        // Sides are counted from +x towards +z, turns go from +x towards -z.
        int places = prism.sides() * quarters / 4;
        return renamed(prism, side -> side - places, end -> end);
    }

    /** Mirrors the faces along the axes whose factors are negative; along x only with an even number of sides. */
    private static Solid.Prism mirrored(Solid.Prism prism, Vec3 factors) {
        int half = factors.x() < 0 ? prism.sides() / 2 : 0;
        int sense = factors.x() * factors.z() < 0 ? -1 : 1;
        UnaryOperator<String> ends = factors.y() < 0 ? SolidTransform::oppositeEnd : end -> end;
        return renamed(prism, side -> half + sense * side, ends);
    }

    /** Leaves names of no face as they are. */
    private static String oppositeEnd(String end) {
        return switch (end) {
            case "+y" -> "-y";
            case "-y" -> "+y";
            default -> end;
        };
    }

    private static Solid.Prism renamed(Solid.Prism prism, IntUnaryOperator sides, UnaryOperator<String> ends) {
        List<String> names = SolidFaces.names(prism);
        Map<String, Solid.Face> faces = new LinkedHashMap<>();
        prism.faces().forEach((name, authored) -> {
            int at = names.indexOf(name);
            boolean isSide = at >= FIRST_SIDE;
            int side = Math.floorMod(sides.applyAsInt(at - FIRST_SIDE), prism.sides());
            faces.put(isSide ? names.get(FIRST_SIDE + side) : ends.apply(name), authored);
        });
        return prism.withFaces(Collections.unmodifiableMap(faces));
    }

    /**
     * A scaling along the axes of the world: each coordinate p becomes factor · (p − pivot) + pivot.
     *
     * @param factors none of them 0; negative ones mirror
     */
    private record AxisScale(Vec3 factors, Vec3 pivot) {
        Vec3 point(Vec3 p) {
            return ExactNumber.clean(times(p.minus(pivot)).plus(pivot), ExactNumber.OF_SUMS);
        }

        Vec3 size(Vec3 size) {
            Vec3 scaled = times(size);
            return ExactNumber.clean(
                    new Vec3(Math.abs(scaled.x()), Math.abs(scaled.y()), Math.abs(scaled.z())), ExactNumber.OF_SUMS);
        }

        private Vec3 times(Vec3 v) {
            return v.times(factors);
        }

        BoxFace side(BoxFace side) {
            return times(side.normal()).dot(side.normal()) < 0 ? SimplestSolid.opposite(side) : side;
        }

        /** Scales a normal by the inverse factors, and finds the distance from a scaled point of the plane. */
        PlaneFace plane(PlaneFace face) {
            Plane before = PlaneForm.plane(face);
            Vec3 inverse = new Vec3(before.nx() / factors.x(), before.ny() / factors.y(), before.nz() / factors.z());
            Vec3 normal = Plane.of(inverse, 0).normal();
            Vec3 on = times(before.normal().scaled(before.distance()).minus(pivot))
                    .plus(pivot);
            PlaneFace moved = PlaneForm.canonical(Plane.through(normal, on));
            double distance = PlaneForm.isAlongAxis(moved.normal())
                    ? ExactNumber.clean(moved.distanceMetres(), ExactNumber.OF_SUMS)
                    : moved.distanceMetres();
            return PlaneForm.at(face, moved.normal(), distance);
        }
    }

    /**
     * A rotation by quarter turns around an axis of the world, without rounding of directions.
     *
     * @param axis 0 for x, 1 for y, 2 for z
     * @param turns 0 to 3, counter-clockwise seen against the axis
     */
    private record QuarterTurn(int axis, int turns) {
        /** Returns the rotation; {@code null} if the axis is none of the world's or the angle no multiple of 90°. */
        static QuarterTurn of(Vec3 axis, double degrees) {
            double quarters = degrees / 90;
            if (!PlaneForm.isAlongAxis(axis) || quarters != Math.rint(quarters)) {
                return null;
            }
            double sign = Math.signum(axis.x() + axis.y() + axis.z());
            int index = axis.x() != 0 ? 0 : axis.y() != 0 ? 1 : 2;
            double fourth = (sign * quarters) % 4;
            return new QuarterTurn(index, Math.floorMod((int) fourth, 4));
        }

        /** Returns a direction turned. */
        Vec3 direction(Vec3 v) {
            Vec3 turned = v;
            for (int i = 0; i < turns; i++) {
                turned = switch (axis) {
                    case 0 -> new Vec3(turned.x(), -turned.z(), turned.y());
                    case 1 -> new Vec3(turned.z(), turned.y(), -turned.x());
                    default -> new Vec3(-turned.y(), turned.x(), turned.z());
                };
            }
            return ExactNumber.positiveZeros(turned);
        }

        /** Returns a point turned around a pivot; numbers of few decimals stay such. */
        Vec3 point(Vec3 p, Vec3 pivot) {
            return ExactNumber.clean(pivot.plus(direction(p.minus(pivot))), ExactNumber.OF_SUMS);
        }

        /** Returns edge lengths turned. */
        Vec3 size(Vec3 size) {
            Vec3 turned = direction(size);
            return new Vec3(Math.abs(turned.x()), Math.abs(turned.y()), Math.abs(turned.z()));
        }

        BoxFace side(BoxFace side) {
            return SimplestSolid.side(direction(side.normal())).orElseThrow();
        }
    }
}
