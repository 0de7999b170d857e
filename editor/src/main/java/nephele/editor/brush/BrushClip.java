package nephele.editor.brush;

import java.util.List;
import nephele.engine.level.Solid;
import nephele.engine.level.Solid.PlaneFace;
import nephele.engine.math.Plane;

/** Clipping of a solid by a plane. */
public final class BrushClip {
    /** The parts of a clipped solid that stay; the plane's normal points to its front. */
    public enum Keep {
        BEHIND,
        IN_FRONT,
        BOTH
    }

    private BrushClip() {}

    /**
     * Returns the parts that stay: one with the solid's id, and for {@link Keep#BOTH} the part in front with another.
     * The two parts share a plane exactly.
     *
     * @param cut what the new face says beside the solid's defaults; {@code null} members inherit
     * @param idInFront id of the part in front if both stay
     */
    public static BrushEdit<List<Solid>> clipped(
            Solid solid, Plane plane, Keep keep, Solid.Face cut, String idInFront) {
        PlaneFace flat = PlaneForm.canonical(plane);
        PlaneFace cap = PlaneForm.look(
                solid,
                flat,
                new Solid.Face(
                        cut.material() == null ? solid.material() : cut.material(), cut.portalable(), cut.texture()));
        BrushEdit<Solid> behind = PlaneCut.behind(solid, cap);
        BrushEdit<Solid> front = PlaneCut.behind(solid, PlaneForm.opposite(cap));
        boolean misses = isWhole(behind, solid) || isWhole(front, solid);
        if (misses) {
            return BrushEdit.refused(BrushText.PLANE_MISSES);
        }
        return behind.flatMap(back -> front.map(fore -> switch (keep) {
            case BEHIND -> List.of(back);
            case IN_FRONT -> List.of(fore);
            case BOTH -> List.of(back, Identity.withId(fore, idInFront));
        }));
    }

    private static boolean isWhole(BrushEdit<Solid> part, Solid solid) {
        return part.result().filter(same -> same == solid).isPresent();
    }
}
