package nephele.editor.brush;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.level.Solid.PlaneFace;
import nephele.engine.math.Aabb;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/** The simplest record for a solid of planes: a box, a wedge or a prism where it has the shape of one. */
public final class SimplestSolid {
    /** Components of unit normals below this are noise of rotations. */
    private static final double NO_COMPONENT = 1e-12;

    /** Difference of planes, relative to 1 m or the distance, below which a wedge or prism is taken for the planes. */
    private static final double SAME_PLANE = 1e-11;

    private SimplestSolid() {}

    /**
     * Returns the same shape with the same id, defaults and faces as a box, a wedge or a prism, or the given solid. Its
     * planes must all have a face.
     */
    public static Solid of(Solid.Planes solid) {
        return box(solid).<Solid>map(box -> box).orElseGet(() -> exceptBox(solid));
    }

    /** Returns the same shape as a wedge or a prism, or the given solid. */
    static Solid exceptBox(Solid.Planes solid) {
        Optional<Solid> wedge = wedge(solid).map(found -> found);
        return wedge.or(() -> prism(solid).map(found -> found)).orElse(solid);
    }

    /** Returns the side of a box with this unit normal; empty for an oblique one. */
    static Optional<BoxFace> side(Vec3 normal) {
        for (BoxFace side : BoxFace.values()) {
            Vec3 difference = normal.minus(side.normal());
            if (Math.abs(difference.x()) <= NO_COMPONENT
                    && Math.abs(difference.y()) <= NO_COMPONENT
                    && Math.abs(difference.z()) <= NO_COMPONENT) {
                return Optional.of(side);
            }
        }
        return Optional.empty();
    }

    private static Map<BoxFace, PlaneFace> sides(Solid.Planes solid) {
        Map<BoxFace, PlaneFace> sides = new EnumMap<>(BoxFace.class);
        for (PlaneFace face : solid.planes()) {
            side(PlaneForm.plane(face).normal()).ifPresent(side -> sides.put(side, face));
        }
        return sides;
    }

    private static Optional<Solid.Face> authored(PlaneFace face) {
        Solid.Face authored = new Solid.Face(face.material(), face.portalable(), face.texture());
        return authored.equals(Solid.Face.INHERITED) ? Optional.empty() : Optional.of(authored);
    }

    private static double at(Map<BoxFace, PlaneFace> sides, BoxFace side) {
        Vec3 n = side.normal();
        return (n.x() + n.y() + n.z()) * sides.get(side).distanceMetres() + 0.0;
    }

    private static Optional<Solid.Box> box(Solid.Planes solid) {
        Map<BoxFace, PlaneFace> sides = sides(solid);
        if (solid.planes().size() != 6 || sides.size() != 6) {
            return Optional.empty();
        }
        Aabb bounds = new Aabb(
                at(sides, BoxFace.MINUS_X),
                at(sides, BoxFace.MINUS_Y),
                at(sides, BoxFace.MINUS_Z),
                at(sides, BoxFace.PLUS_X),
                at(sides, BoxFace.PLUS_Y),
                at(sides, BoxFace.PLUS_Z));
        Map<BoxFace, Solid.Face> faces = new EnumMap<>(BoxFace.class);
        sides.forEach((side, face) -> authored(face).ifPresent(authored -> faces.put(side, authored)));
        return Optional.of(new Solid.Box(
                solid.id(),
                solid.material(),
                solid.portalable(),
                solid.textureMapping(),
                ExactNumber.centre(bounds),
                ExactNumber.size(bounds),
                Collections.unmodifiableMap(faces)));
    }

    private static Optional<Solid.Wedge> wedge(Solid.Planes solid) {
        Map<BoxFace, PlaneFace> sides = sides(solid);
        boolean isWedge = solid.planes().size() == 5
                && sides.size() == 4
                && sides.containsKey(BoxFace.MINUS_Y)
                && !sides.containsKey(BoxFace.PLUS_Y);
        if (!isWedge) {
            return Optional.empty();
        }
        PlaneFace slope = solid.planes().stream()
                .filter(face -> !sides.containsValue(face))
                .findFirst()
                .orElseThrow();
        return sides.keySet().stream()
                .filter(side -> side.normal().y() == 0 && !sides.containsKey(opposite(side)))
                .findFirst()
                .flatMap(rising -> wedge(solid, rising, slope, sides));
    }

    static BoxFace opposite(BoxFace side) {
        return BoxFace.values()[side.ordinal() ^ 1];
    }

    /** Derives the low edge and the top edge from the slope, and accepts the wedge if it has the same slope. */
    private static Optional<Solid.Wedge> wedge(
            Solid.Planes solid, BoxFace rising, PlaneFace slopeFace, Map<BoxFace, PlaneFace> sides) {
        Plane slope = PlaneForm.plane(slopeFace);
        Vec3 high = rising.normal();
        double along = slope.nx() * high.x() + slope.nz() * high.z();
        boolean isAcross = Math.abs(high.x() != 0 ? slope.nz() : slope.nx()) > NO_COMPONENT;
        if (isAcross || along > -NO_COMPONENT || slope.ny() < NO_COMPONENT) {
            return Optional.empty();
        }
        double bottom = at(sides, BoxFace.MINUS_Y);
        double highAt = sides.get(rising).distanceMetres();
        double top = (slope.distance() - along * highAt) / slope.ny();
        double lowAt = (slope.distance() - slope.ny() * bottom) / along;
        // A shift of the slope moves its edges by more the flatter it is.
        double noise = ExactNumber.OF_INTERSECTIONS / Math.min(-along, slope.ny());
        Aabb box = bounds(sides, rising, new double[] {bottom, top, lowAt, highAt});
        Map<String, Solid.Face> faces = new LinkedHashMap<>();
        sides.forEach((side, face) -> authored(face).ifPresent(authored -> faces.put(side.text(), authored)));
        authored(slopeFace).ifPresent(authored -> faces.put("slope", authored));
        Solid.Wedge wedge = new Solid.Wedge(
                solid.id(),
                solid.material(),
                solid.portalable(),
                solid.textureMapping(),
                ExactNumber.centre(box, noise),
                ExactNumber.size(box, noise),
                rising,
                Collections.unmodifiableMap(faces));
        return hasPlanes(wedge, solid) ? Optional.of(wedge) : Optional.empty();
    }

    private static Aabb bounds(Map<BoxFace, PlaneFace> sides, BoxFace rising, double[] bottomTopLowHigh) {
        Vec3 high = rising.normal();
        double sign = high.x() + high.z();
        double a = Math.min(sign * bottomTopLowHigh[2], sign * bottomTopLowHigh[3]);
        double b = Math.max(sign * bottomTopLowHigh[2], sign * bottomTopLowHigh[3]);
        double bottom = bottomTopLowHigh[0];
        double top = bottomTopLowHigh[1];
        return high.x() != 0
                ? new Aabb(a, bottom, at(sides, BoxFace.MINUS_Z), b, top, at(sides, BoxFace.PLUS_Z))
                : new Aabb(at(sides, BoxFace.MINUS_X), bottom, a, at(sides, BoxFace.PLUS_X), top, b);
    }

    /** Returns true if the candidate is valid and has the planes of the solid, up to noise. */
    private static boolean hasPlanes(Solid candidate, Solid.Planes solid) {
        List<Plane> open = new ArrayList<>();
        solid.planes().forEach(face -> open.add(PlaneForm.plane(face)));
        try {
            for (Brush.BrushFace face : Brush.of(candidate).faces()) {
                open.removeIf(plane -> isSame(plane, face.plane()));
            }
        } catch (IllegalArgumentException notSolid) {
            return false;
        }
        return open.isEmpty();
    }

    static boolean isSame(Plane a, Plane b) {
        return a.normal().minus(b.normal()).length() <= SAME_PLANE
                && Math.abs(a.distance() - b.distance()) <= SAME_PLANE * Math.max(1, Math.abs(a.distance()));
    }

    private static Optional<Solid.Prism> prism(Solid.Planes solid) {
        Map<BoxFace, PlaneFace> ends = sides(solid);
        int sides = solid.planes().size() - 2;
        List<PlaneFace> upright = solid.planes().stream()
                .filter(face -> Math.abs(face.normal().y()) <= NO_COMPONENT)
                .toList();
        boolean isPrism = sides >= 3
                && upright.size() == sides
                && ends.containsKey(BoxFace.PLUS_Y)
                && ends.containsKey(BoxFace.MINUS_Y);
        return isPrism ? prism(solid, upright, ends) : Optional.empty();
    }

    /** Takes apothem and axis as the means of the sides, whose normals cancel in a regular prism. */
    private static Optional<Solid.Prism> prism(
            Solid.Planes solid, List<PlaneFace> upright, Map<BoxFace, PlaneFace> ends) {
        double apothem = 0;
        double x = 0;
        double z = 0;
        for (PlaneFace face : upright) {
            Plane plane = PlaneForm.plane(face);
            apothem += plane.distance() / upright.size();
            x += 2 * plane.nx() * plane.distance() / upright.size();
            z += 2 * plane.nz() * plane.distance() / upright.size();
        }
        double top = at(ends, BoxFace.PLUS_Y);
        double bottom = at(ends, BoxFace.MINUS_Y);
        double radius = apothem / StrictMath.cos(Math.PI / upright.size());
        Solid.Prism prism = new Solid.Prism(
                solid.id(),
                solid.material(),
                solid.portalable(),
                solid.textureMapping(),
                ExactNumber.clean(new Vec3(x, (top + bottom) / 2, z), ExactNumber.OF_INTERSECTIONS),
                ExactNumber.clean(radius, ExactNumber.OF_INTERSECTIONS),
                ExactNumber.clean(top - bottom, ExactNumber.OF_SUMS),
                upright.size(),
                Map.of());
        return hasPlanes(prism, solid) ? Optional.of(saying(prism, solid)) : Optional.empty();
    }

    private static Solid.Prism saying(Solid.Prism prism, Solid.Planes solid) {
        Map<String, Solid.Face> faces = new LinkedHashMap<>();
        for (Brush.BrushFace face : Brush.of(prism).faces()) {
            solid.planes().stream()
                    .filter(plane -> isSame(PlaneForm.plane(plane), face.plane()))
                    .findFirst()
                    .flatMap(SimplestSolid::authored)
                    .ifPresent(authored -> faces.put(face.name(), authored));
        }
        return prism.withFaces(Collections.unmodifiableMap(faces));
    }
}
