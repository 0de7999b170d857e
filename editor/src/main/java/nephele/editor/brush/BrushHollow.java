package nephele.editor.brush;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import nephele.engine.level.Solid;
import nephele.engine.level.Solid.PlaneFace;

/** Hollowing of a solid. */
public final class BrushHollow {
    private BrushHollow() {}

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
        return BrushBoolean.carved(solid, inner, room.get())
                .map(slabs -> BrushBoolean.identified(slabs, solid.id(), newIds));
    }

    private static PlaneFace inside(PlaneFace face, double wallMetres) {
        double sum = face.distanceMetres() - wallMetres;
        double distance = PlaneForm.isAlongAxis(face.normal())
                ? ExactNumber.clean(sum, ExactNumber.OF_SUMS)
                : ExactNumber.snapped(sum);
        return PlaneForm.at(face, face.normal(), distance);
    }
}
