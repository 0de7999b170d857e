package nephele.editor.brush;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.level.Solid.PlaneFace;
import nephele.engine.math.Vec3;

/** Boolean operations on convex solids (constructive solid geometry), and hollowing. */
public final class BrushBoolean {
    /** Fraction of the volume that may be missing from a union that counts as convex. */
    private static final double SAME_VOLUME = 1e-9;

    private BrushBoolean() {}

    /**
     * Returns convex pieces that tile the solid without the cutter; none if the cutter covers it. Neighbours share their
     * planes exactly. The first piece keeps the id. Parts thinner than 0.1 mm are dropped, and an overlap thinner than
     * that is no overlap: the solid itself is returned.
     */
    public static BrushEdit<List<Solid>> subtracted(Solid solid, Solid cutter, Supplier<String> newIds) {
        BrushEdit<Solid> common = intersected(solid, cutter);
        Optional<BrushText> why = common.refusal();
        if (why.isPresent()) {
            boolean isApart = why.get() == BrushText.NO_OVERLAP || why.get() == BrushText.TOO_THIN;
            return isApart ? BrushEdit.done(List.of(solid)) : BrushEdit.refused(why.get());
        }
        List<PlaneFace> caps = Brush.of(cutter).faces().stream()
                .map(face -> PlaneForm.canonical(face.plane()))
                .toList();
        return carved(solid, caps, common.result().orElseThrow()).map(pieces -> identified(pieces, solid.id(), newIds));
    }

    /**
     * Returns what is in front of one of the planes: of the rest behind those before, each cuts off a piece. Refused if
     * more is lost than slivers, as happens where the engine cannot separate the corners of a piece.
     *
     * @param inside the part of the solid that is behind all planes
     */
    private static BrushEdit<List<Solid>> carved(Solid solid, List<PlaneFace> planes, Solid inside) {
        List<Solid> pieces = new ArrayList<>();
        Solid rest = solid;
        for (PlaneFace plane : planes) {
            BrushEdit<Solid> piece = BrushClip.behind(rest, PlaneForm.opposite(plane));
            BrushEdit<Solid> behind = BrushClip.behind(rest, plane);
            if (isTooMuch(piece) || isTooMuch(behind)) {
                return BrushEdit.refused(BrushText.TOO_MANY_FACES);
            }
            if (piece.result().isPresent() && behind.result().isPresent()) {
                pieces.add(piece.result().get());
                rest = behind.result().get();
            }
        }
        double lost = volume(solid) - volume(inside);
        for (Solid piece : pieces) {
            lost -= volume(piece);
        }
        double slivers =
                BrushCheck.LEAST_THICKNESS_METRES * Brush.of(solid).shape().surfaceSquareMetres();
        return Math.abs(lost) <= slivers ? BrushEdit.done(pieces) : BrushEdit.refused(BrushText.NOT_SOLID);
    }

    private static boolean isTooMuch(BrushEdit<Solid> edit) {
        return edit.refusal().filter(BrushText.TOO_MANY_FACES::equals).isPresent();
    }

    private static List<Solid> identified(List<Solid> pieces, String first, Supplier<String> newIds) {
        List<Solid> named = new ArrayList<>(pieces.size());
        for (Solid piece : pieces) {
            named.add(piece.withId(named.isEmpty() ? first : newIds.get()));
        }
        return List.copyOf(named);
    }

    /**
     * Returns what two solids have in common, with the first one's id and defaults. A face of the second keeps its look;
     * a grey one has the default.
     */
    static BrushEdit<Solid> intersected(Solid a, Solid b) {
        BrushEdit<Solid> common = BrushEdit.done(a);
        for (Brush.BrushFace face : Brush.of(b).faces()) {
            Solid.Face look = new Solid.Face(
                    face.material() == null ? a.material() : face.material(), face.portalable(), face.texture());
            PlaneFace cap = PlaneForm.look(a, PlaneForm.canonical(face.plane()), look);
            common = common.flatMap(rest -> BrushClip.behind(rest, cap));
        }
        boolean isApart =
                common.refusal().filter(BrushText.NOTHING_LEFT::equals).isPresent();
        return isApart ? BrushEdit.refused(BrushText.NO_OVERLAP) : common;
    }

    /**
     * Returns the convex hull of several solids with the first one's id and defaults; each face has the look of the
     * largest one on its plane, or else of the one with the nearest normal.
     */
    public static BrushEdit<Solid> merged(List<Solid> solids) {
        if (solids.isEmpty()) {
            return BrushEdit.refused(BrushText.NO_BRUSHES);
        }
        Solid first = solids.get(0);
        if (solids.size() == 1) {
            return BrushEdit.done(first);
        }
        Set<Vec3> corners = new LinkedHashSet<>();
        solids.forEach(solid -> corners.addAll(Brush.of(solid).shape().vertices()));
        List<Vec3> points = List.copyOf(corners);
        if (points.size() > ConvexHull.MOST_POINTS) {
            return BrushEdit.refused(BrushText.TOO_MANY_VERTICES);
        }
        HullFaces old = new HullFaces(solids, points);
        List<ConvexHull.Side> sides = ConvexHull.of(points);
        List<HullFaces.OldFace> likes =
                sides.stream().map(side -> old.nearest(side.plane())).toList();
        boolean needsGrey = likes.stream().anyMatch(like -> like.face().material() == null);
        Solid template =
                first.with(first.id(), needsGrey ? null : first.material(), first.portalable(), first.textureMapping());
        List<PlaneFace> planes = new ArrayList<>();
        for (int i = 0; i < sides.size(); i++) {
            planes.add(old.plane(template, sides.get(i), likes.get(i)));
        }
        return PlaneForm.rebuilt(PlaneForm.with(template, first.id(), planes));
    }

    /** Returns true if solids fill their convex hull, so that merging them changes no shape. */
    public static boolean isUnionConvex(List<Solid> solids) {
        BrushEdit<Solid> hull = merged(solids);
        if (hull.result().isEmpty()) {
            return false;
        }
        Solid whole = hull.result().get();
        List<Solid> open = List.of(whole);
        for (Solid solid : solids) {
            List<Solid> left = new ArrayList<>();
            for (Solid piece : open) {
                BrushEdit<List<Solid>> rest = subtracted(piece, solid, whole::id);
                if (rest.result().isEmpty()) {
                    return false;
                }
                left.addAll(rest.result().get());
            }
            open = left;
        }
        double missing = open.stream().mapToDouble(BrushBoolean::volume).sum();
        return missing <= SAME_VOLUME * volume(whole);
    }

    private static double volume(Solid solid) {
        return Brush.of(solid).shape().volumeCubicMetres();
    }

    /**
     * Returns walls that fill the solid up to a depth below its faces: one slab for each face that others do not cover,
     * without overlap. Floors and ceilings reach over the walls; a slab shows its face's look on the inside, too. The
     * first slab keeps the id.
     */
    public static BrushEdit<List<Solid>> hollowed(Solid solid, double wallMetres, Supplier<String> newIds) {
        Solid.Planes planes = PlaneForm.of(solid);
        if (!(wallMetres >= BrushCheck.LEAST_THICKNESS_METRES)) {
            return BrushEdit.refused(BrushText.TOO_THIN);
        }
        List<PlaneFace> inner = new ArrayList<>();
        planes.planes().forEach(face -> inner.add(inside(face, wallMetres)));
        inner.sort(Comparator.comparingDouble(
                face -> -Math.abs(PlaneForm.plane(face).ny())));
        Optional<Solid> room =
                PlaneForm.rebuilt(PlaneForm.with(solid, solid.id(), inner)).result();
        if (room.isEmpty()) {
            return BrushEdit.refused(BrushText.WALL_TOO_THICK);
        }
        return carved(solid, inner, room.get()).map(slabs -> identified(slabs, solid.id(), newIds));
    }

    private static PlaneFace inside(PlaneFace face, double wallMetres) {
        double sum = face.distanceMetres() - wallMetres;
        double distance = PlaneForm.isAlongAxis(face.normal())
                ? ExactNumber.clean(sum, ExactNumber.OF_SUMS)
                : ExactNumber.snapped(sum);
        return PlaneForm.at(face, face.normal(), distance);
    }
}
