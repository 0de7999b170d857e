package nephele.editor.brush;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.level.Solid.PlaneFace;
import nephele.engine.math.PolyhedronMeasure;

/** Boolean operations on convex solids (constructive solid geometry). */
public final class BrushBoolean {
    /** Share of the volume that may be missing from a union that counts as convex. */
    private static final double SAME_VOLUME = 1e-9;

    /** The material source of the faces that a cut adds. */
    public enum CutLook {
        /** The solid's default material and portalability. */
        OF_SOLID,
        /** Material, portalability and placement of the picture of the cutter's face; a grey one is the solid's default. */
        OF_CUTTER
    }

    private BrushBoolean() {}

    /**
     * Returns convex pieces that tile the solid without the cutter; none if the cutter covers it. Neighbours share their
     * planes exactly. The first piece keeps the id. Parts thinner than 0.1 mm are dropped, and an overlap thinner than
     * that is no overlap: the solid itself is returned.
     */
    public static BrushEdit<List<Solid>> subtracted(Solid solid, Solid cutter, CutLook look, Supplier<String> newIds) {
        BrushEdit<Solid> common = intersected(solid, cutter);
        Optional<BrushText> why = common.refusal();
        if (why.isPresent()) {
            boolean isApart = why.get() == BrushText.NO_OVERLAP || why.get() == BrushText.TOO_THIN;
            return isApart ? BrushEdit.done(List.of(solid)) : BrushEdit.refused(why.get());
        }
        return carved(solid, caps(solid, cutter, look), common.result().orElseThrow())
                .map(pieces -> identified(pieces, solid.id(), newIds));
    }

    private static List<PlaneFace> caps(Solid solid, Solid cutter, CutLook look) {
        List<PlaneFace> caps = new ArrayList<>();
        for (Brush.BrushFace face : Brush.of(cutter).faces()) {
            PlaneFace cap = PlaneForm.canonical(face.plane());
            Solid.Face shown = new Solid.Face(
                    face.material() == null ? solid.material() : face.material(), face.portalable(), face.texture());
            caps.add(look == CutLook.OF_CUTTER ? PlaneForm.look(solid, cap, shown) : cap);
        }
        return caps;
    }

    /**
     * Returns what is in front of one of the planes: of the rest behind those before, each cuts off a piece. Refused if
     * more is lost than slivers, as happens where the engine cannot separate the corners of a piece.
     *
     * @param inside the part of the solid that is behind all planes
     */
    static BrushEdit<List<Solid>> carved(Solid solid, List<PlaneFace> planes, Solid inside) {
        List<Solid> pieces = new ArrayList<>();
        Solid rest = solid;
        for (PlaneFace plane : planes) {
            BrushEdit<Solid> piece = PlaneCut.behind(rest, PlaneForm.opposite(plane));
            BrushEdit<Solid> behind = PlaneCut.behind(rest, plane);
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
        double slivers = BrushCheck.LEAST_THICKNESS_METRES
                * PolyhedronMeasure.surfaceSquareMetres(Brush.of(solid).shape());
        return Math.abs(lost) <= slivers ? BrushEdit.done(pieces) : BrushEdit.refused(BrushText.NOT_SOLID);
    }

    private static boolean isTooMuch(BrushEdit<Solid> edit) {
        return edit.refusal().filter(BrushText.TOO_MANY_FACES::equals).isPresent();
    }

    static List<Solid> identified(List<Solid> pieces, String first, Supplier<String> newIds) {
        List<Solid> named = new ArrayList<>(pieces.size());
        for (Solid piece : pieces) {
            named.add(Identity.withId(piece, named.isEmpty() ? first : newIds.get()));
        }
        return List.copyOf(named);
    }

    /**
     * Returns what two solids have in common, with the first one's id and defaults. A face of the second keeps its look;
     * a grey one has the default.
     */
    public static BrushEdit<Solid> intersected(Solid a, Solid b) {
        BrushEdit<Solid> common = BrushEdit.done(a);
        for (PlaneFace cap : caps(a, b, CutLook.OF_CUTTER)) {
            common = common.flatMap(rest -> PlaneCut.behind(rest, cap));
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
        return solids.isEmpty() ? BrushEdit.refused(BrushText.NO_BRUSHES) : MergedHull.of(solids);
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
                BrushEdit<List<Solid>> rest = subtracted(piece, solid, CutLook.OF_SOLID, whole::id);
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
        return PolyhedronMeasure.volumeCubicMetres(Brush.of(solid).shape());
    }
}
