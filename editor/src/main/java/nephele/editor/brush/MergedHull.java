package nephele.editor.brush;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.level.Solid.PlaneFace;
import nephele.engine.math.Vec3;

/** The convex hull of several solids as one. */
final class MergedHull {
    private MergedHull() {}

    static BrushEdit<Solid> of(List<Solid> solids) {
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
        List<HullFaces.Old> likes =
                sides.stream().map(side -> old.nearest(side.plane())).toList();
        boolean needsGrey = likes.stream().anyMatch(like -> like.face().material() == null);
        BrushStyle style =
                new BrushStyle(needsGrey ? null : first.material(), first.portalable(), first.textureMapping());
        Solid template = Identity.with(first, first.id(), style);
        List<PlaneFace> planes = new ArrayList<>();
        for (int i = 0; i < sides.size(); i++) {
            planes.add(old.written(template, sides.get(i), likes.get(i)));
        }
        return PlaneForm.rebuilt(PlaneForm.with(template, first.id(), planes));
    }
}
