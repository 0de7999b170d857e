package nephele.editor.brush;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Solid;
import nephele.engine.level.Solid.PlaneFace;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/** Extrusion of a face along its normal. Faces are counted in the order of {@code Brush.of(solid).faces()}. */
public final class FaceExtrude {
    private FaceExtrude() {}

    /** Returns the solid with a face moved outwards by a distance in metres, or inwards by a negative one. */
    public static BrushEdit<Solid> extruded(Solid solid, int face, double metres) {
        if (solid instanceof Solid.Box box) {
            Vec3 normal = BoxFace.values()[face].normal();
            return resized(box.size(), normal, metres)
                    .flatMap(size -> BrushCheck.checked(
                            SolidTransform.placed(box, shifted(box.centre(), normal, metres), size)));
        } else if (solid instanceof Solid.Prism prism && face < 2) {
            Vec3 normal = BoxFace.values()[BoxFace.PLUS_Y.ordinal() + face].normal();
            return resized(new Vec3(0, prism.heightMetres(), 0), normal, metres)
                    .flatMap(size -> BrushCheck.checked(SolidTransform.placed(
                            prism, shifted(prism.centre(), normal, metres), prism.radiusMetres(), size.y())));
        } else if (solid instanceof Solid.Wedge wedge && isEnd(wedge, face)) {
            Vec3 normal = Brush.of(wedge).faces().get(face).plane().normal();
            return resized(wedge.size(), normal, metres)
                    .flatMap(size -> BrushCheck.checked(
                            SolidTransform.placed(wedge, shifted(wedge.centre(), normal, metres), size)));
        }
        return planeMoved(PlaneForm.of(solid), face, metres);
    }

    /** The triangular ends of a wedge move without a change of the slope. */
    private static boolean isEnd(Solid.Wedge wedge, int face) {
        Vec3 normal = Brush.of(wedge).faces().get(face).plane().normal();
        return normal.y() == 0 && normal.dot(wedge.rising().normal()) == 0;
    }

    private static BrushEdit<Vec3> resized(Vec3 size, Vec3 normal, double metres) {
        Vec3 along = new Vec3(Math.abs(normal.x()), Math.abs(normal.y()), Math.abs(normal.z()));
        Vec3 changed = ExactNumber.clean(size.addScaled(metres, along), ExactNumber.OF_SUMS);
        return changed.dot(along) > 0 ? BrushEdit.done(changed) : BrushEdit.refused(BrushText.NOTHING_LEFT);
    }

    private static Vec3 shifted(Vec3 centre, Vec3 normal, double metres) {
        return ExactNumber.clean(centre.addScaled(metres / 2, normal), ExactNumber.OF_SUMS);
    }

    private static BrushEdit<Solid> planeMoved(Solid.Planes solid, int face, double metres) {
        Plane before = PlaneForm.plane(solid.planes().get(face));
        Plane after = new Plane(before.nx(), before.ny(), before.nz(), before.distance() + metres);
        PlaneFace authored = solid.planes().get(face);
        double distance = PlaneForm.canonical(after).distanceMetres();
        List<PlaneFace> planes = new ArrayList<>(solid.planes());
        planes.set(face, PlaneForm.at(authored, authored.normal(), distance));
        BrushEdit<Solid> moved = PlaneForm.rebuilt(PlaneForm.with(solid, solid.id(), planes));
        if (moved.result().isEmpty()) {
            boolean isEmpty =
                    moved.refusal().filter(BrushText.NOT_SOLID::equals).isPresent();
            return isEmpty ? BrushEdit.refused(BrushText.NOTHING_LEFT) : moved;
        }
        List<BrushFace> faces = Brush.of(moved.result().get()).faces();
        boolean isThere = faces.stream().anyMatch(kept -> SimplestSolid.isSame(kept.plane(), after));
        return isThere ? moved : BrushEdit.refused(BrushText.FACE_VANISHES);
    }

    /**
     * Returns the solid and a new one: outwards, the new one grows from the face with upright sides; inwards, by a
     * negative distance, the solid is split at that depth and the new one is the part at the face.
     */
    public static BrushEdit<List<Solid>> extrudedAsNew(Solid solid, int face, double metres, String newId) {
        Brush brush = Brush.of(solid);
        BrushFace from = brush.faces().get(face);
        if (metres < 0) {
            Plane plane = new Plane(
                    from.plane().nx(),
                    from.plane().ny(),
                    from.plane().nz(),
                    from.plane().distance() + metres);
            return BrushClip.clipped(solid, plane, BrushClip.Keep.BOTH, PlaneForm.lookOf(from), newId);
        }
        if (from.polygon().size() + 2 > ConvexPolyhedron.MAX_PLANES) {
            return BrushEdit.refused(BrushText.TOO_MANY_FACES);
        }
        Plane cap = from.plane();
        List<PlaneFace> planes = new ArrayList<>();
        planes.add(looking(solid, new Plane(cap.nx(), cap.ny(), cap.nz(), cap.distance() + metres), from));
        planes.add(looking(solid, cap.opposite(), from));
        for (int i = 0; i < from.polygon().size(); i++) {
            Vec3 a = from.polygon().get(i);
            Vec3 b = from.polygon().get((i + 1) % from.polygon().size());
            BrushFace beside = beside(brush, from, a, b);
            planes.add(looking(solid, side(cap, a, b, beside.plane()), beside));
        }
        return PlaneForm.rebuilt(PlaneForm.with(solid, newId, planes)).map(grown -> List.of(solid, grown));
    }

    private static PlaneFace looking(Solid solid, Plane plane, BrushFace look) {
        return PlaneForm.look(solid, PlaneForm.canonical(plane), PlaneForm.lookOf(look));
    }

    /** Returns the plane through an edge along the normal: the neighbour's own where that is perpendicular. */
    private static Plane side(Plane cap, Vec3 a, Vec3 b, Plane neighbour) {
        if (cap.normal().dot(neighbour.normal()) == 0) {
            return neighbour;
        }
        Vec3 outwards = Plane.of(b.minus(a).cross(cap.normal()), 0).normal();
        return Plane.through(SimplestSolid.side(outwards).map(BoxFace::normal).orElse(outwards), a);
    }

    private static BrushFace beside(Brush brush, BrushFace face, Vec3 a, Vec3 b) {
        return brush.faces().stream()
                .filter(other -> other != face
                        && other.polygon().contains(a)
                        && other.polygon().contains(b))
                .findFirst()
                .orElse(face);
    }
}
