package nephele.editor.brush;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Solid;
import nephele.engine.level.Solid.PlaneFace;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/** Holds the faces of solids before an edit; the sides of their new convex hull take plane and look from them. */
final class HullFaces {
    private static final double SAME_NORMAL = 3e-5;
    private static final double SAME_POINT = 1e-9;

    /**
     * A face before the edit.
     *
     * @param plane as the solid writes it
     */
    record OldFace(BrushFace face, PlaneFace plane) {}

    private final List<OldFace> old = new ArrayList<>();
    private final List<Vec3> points;
    private final double tolerance;

    HullFaces(List<Solid> solids, List<Vec3> points) {
        this.points = points;
        tolerance = ConvexHull.tolerance(points);
        for (Solid solid : solids) {
            List<BrushFace> faces = Brush.of(solid).faces();
            List<PlaneFace> planes = PlaneForm.of(solid).planes();
            for (int i = 0; i < faces.size(); i++) {
                old.add(new OldFace(faces.get(i), planes.get(i)));
            }
        }
    }

    List<OldFace> all() {
        return old;
    }

    /**
     * Returns the side with the look of an old face, and with its very plane if that holds all points of the side, so
     * that faces which an edit does not touch keep their bits.
     */
    PlaneFace plane(Solid template, ConvexHull.Side side, OldFace like) {
        PlaneFace plane = PlaneForm.canonical(side.plane());
        for (OldFace candidate : old) {
            if (isOn(side, candidate)) {
                plane = candidate.plane;
                break;
            }
        }
        return PlaneForm.look(template, plane, PlaneForm.lookOf(like.face));
    }

    private boolean isOn(ConvexHull.Side side, OldFace candidate) {
        Plane plane = candidate.face.plane();
        double farthest = Math.max(1, Math.abs(plane.distance()));
        return side.plane().normal().minus(plane.normal()).length() <= SAME_NORMAL
                && side.on().stream()
                        .allMatch(i -> Math.abs(plane.signedDistance(points.get(i))) <= SAME_POINT * farthest);
    }

    /** Returns the largest old face on the plane of a side; if there is none, the one with the nearest normal. */
    OldFace nearest(Plane plane) {
        OldFace best = null;
        double bestScore = Double.NEGATIVE_INFINITY;
        for (OldFace candidate : old) {
            double cosine = candidate.face.plane().normal().dot(plane.normal());
            boolean isOn = cosine > 0
                    && candidate.face.polygon().stream().allMatch(p -> Math.abs(plane.signedDistance(p)) <= tolerance);
            double score = isOn ? 2 + ConvexPolyhedron.areaSquareMetres(candidate.face.polygon()) : cosine;
            if (score > bestScore) {
                best = candidate;
                bestScore = score;
            }
        }
        return best;
    }
}
