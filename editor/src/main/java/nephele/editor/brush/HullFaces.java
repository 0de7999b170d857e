package nephele.editor.brush;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Solid;
import nephele.engine.level.Solid.PlaneFace;
import nephele.engine.math.Plane;
import nephele.engine.math.PolyhedronMeasure;
import nephele.engine.math.Vec3;

/** The faces of solids before an edit, from which the sides of a convex hull take plane and look. */
final class HullFaces {
    private static final double SAME_NORMAL = 3e-5;
    private static final double SAME_POINT = 1e-9;

    /**
     * A face before the edit.
     *
     * @param written its plane as the solid writes it
     */
    record Old(BrushFace face, PlaneFace written) {}

    private final List<Old> old = new ArrayList<>();
    private final List<Vec3> points;
    private final double tolerance;

    HullFaces(List<Solid> solids, List<Vec3> points) {
        this.points = points;
        tolerance = ConvexHull.tolerance(points);
        for (Solid solid : solids) {
            List<BrushFace> faces = Brush.of(solid).faces();
            List<PlaneFace> planes = PlaneForm.of(solid).planes();
            for (int i = 0; i < faces.size(); i++) {
                old.add(new Old(faces.get(i), planes.get(i)));
            }
        }
    }

    List<Old> all() {
        return old;
    }

    /**
     * Returns the side with the look of an old face, and with its very plane if that holds all points of the side, so
     * that faces which an edit does not touch keep their bits.
     */
    PlaneFace written(Solid template, ConvexHull.Side side, Old like) {
        PlaneFace plane = PlaneForm.canonical(side.plane());
        for (Old candidate : old) {
            if (isOn(side, candidate)) {
                plane = candidate.written;
                break;
            }
        }
        return PlaneForm.look(template, plane, PlaneForm.lookOf(like.face));
    }

    private boolean isOn(ConvexHull.Side side, Old candidate) {
        Plane plane = candidate.face.plane();
        double farthest = Math.max(1, Math.abs(plane.distance()));
        return side.plane().normal().minus(plane.normal()).length() <= SAME_NORMAL
                && side.on().stream()
                        .allMatch(i -> Math.abs(plane.signedDistance(points.get(i))) <= SAME_POINT * farthest);
    }

    /** Returns the largest old face on the plane of a side; if there is none, the one with the nearest normal. */
    Old nearest(Plane plane) {
        Old best = null;
        double bestScore = Double.NEGATIVE_INFINITY;
        for (Old candidate : old) {
            double cosine = candidate.face.plane().normal().dot(plane.normal());
            boolean isOn = cosine > 0
                    && candidate.face.polygon().stream().allMatch(p -> Math.abs(plane.signedDistance(p)) <= tolerance);
            double score = isOn ? 2 + PolyhedronMeasure.areaSquareMetres(candidate.face.polygon()) : cosine;
            if (score > bestScore) {
                best = candidate;
                bestScore = score;
            }
        }
        return best;
    }
}
