package nephele.editor.brush;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.level.Solid.PlaneFace;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/** Clipping of a solid by a plane. */
public final class BrushClip {
    /** Corners nearer to the plane are on it, relative to 1 m or the solid's farthest coordinate. */
    private static final double ON_PLANE = 1e-9;

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
        BrushEdit<Solid> behind = behind(solid, cap);
        BrushEdit<Solid> front = behind(solid, PlaneForm.opposite(cap));
        boolean misses = isWhole(behind, solid) || isWhole(front, solid);
        if (misses) {
            return BrushEdit.refused(BrushText.PLANE_MISSES);
        }
        return behind.flatMap(back -> front.map(fore -> keep == Keep.BOTH
                ? List.of(back, fore.withId(idInFront))
                : List.of(keep == Keep.BEHIND ? back : fore)));
    }

    private static boolean isWhole(BrushEdit<Solid> part, Solid solid) {
        return part.result().filter(same -> same == solid).isPresent();
    }

    /** Returns the solid itself if nothing of it is in front of the plane, and a refusal if nothing is left of it. */
    static BrushEdit<Solid> behind(Solid solid, PlaneFace cap) {
        Plane plane = PlaneForm.plane(cap);
        ConvexPolyhedron shape = Brush.of(solid).shape();
        double tolerance = tolerance(shape);
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (Vec3 corner : shape.vertices()) {
            double distance = plane.signedDistance(corner);
            least = Math.min(least, distance);
            most = Math.max(most, distance);
        }
        if (most <= tolerance) {
            return BrushEdit.done(solid);
        } else if (least >= -tolerance) {
            return BrushEdit.refused(BrushText.NOTHING_LEFT);
        }
        List<PlaneFace> faces = new ArrayList<>();
        List<PlaneFace> all = PlaneForm.of(solid).planes();
        for (int i = 0; i < all.size(); i++) {
            // Only faces wholly in front cannot bound what is behind.
            if (shape.faces().get(i).polygon().stream().anyMatch(p -> plane.signedDistance(p) <= tolerance)) {
                faces.add(all.get(i));
            }
        }
        faces.add(cap);
        BrushEdit<Solid> part = PlaneForm.rebuilt(PlaneForm.with(solid, solid.id(), faces));
        boolean isSliver = least > -BrushCheck.LEAST_THICKNESS_METRES
                && part.refusal().filter(BrushText.NOT_SOLID::equals).isPresent();
        return isSliver ? BrushEdit.refused(BrushText.TOO_THIN) : part;
    }

    static double tolerance(ConvexPolyhedron shape) {
        double farthest = 1;
        for (Vec3 corner : shape.vertices()) {
            farthest = Math.max(
                    farthest, Math.max(Math.abs(corner.x()), Math.max(Math.abs(corner.y()), Math.abs(corner.z()))));
        }
        return ON_PLANE * farthest;
    }
}
