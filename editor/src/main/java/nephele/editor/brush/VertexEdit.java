package nephele.editor.brush;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.level.Solid.PlaneFace;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Vec3;

/** Editing of a solid by its vertices and edges. */
public final class VertexEdit {
    private static final int FACES_AT_A_VERTEX = 3;

    /** An edge of a solid. */
    public record Edge(Vec3 from, Vec3 to) {
        public Vec3 middle() {
            return from.lerp(to, 0.5);
        }
    }

    private final Solid solid;
    private final List<Vec3> points;
    private final BitSet edited;

    private VertexEdit(Solid solid, List<Vec3> points, BitSet edited) {
        this.solid = solid;
        this.points = points;
        this.edited = edited;
    }

    /** Returns the vertices of a solid. */
    public static List<Vec3> vertices(Solid solid) {
        return Brush.of(solid).shape().vertices();
    }

    /** Returns every edge of a solid once. */
    public static List<Edge> edges(Solid solid) {
        Set<Edge> edges = new LinkedHashSet<>();
        for (ConvexPolyhedron.Face face : Brush.of(solid).shape().faces()) {
            for (int i = 0; i < face.polygon().size(); i++) {
                Vec3 a = face.polygon().get(i);
                Vec3 b = face.polygon().get((i + 1) % face.polygon().size());
                if (!edges.contains(new Edge(b, a))) {
                    edges.add(new Edge(a, b));
                }
            }
        }
        return List.copyOf(edges);
    }

    /**
     * Returns the convex hull with some vertices moved; for an edge both its ends are given. Faces keep material,
     * portalability and, where no vertex of them moves, their plane. Refused if a moved vertex would be none any more,
     * unless it coincides with another, or if nothing solid remains.
     *
     * @param vertices positions that {@link #vertices} returned
     */
    public static BrushEdit<Solid> moved(Solid solid, Collection<Vec3> vertices, Vec3 by) {
        List<Vec3> points = new ArrayList<>(vertices(solid));
        BitSet edited = new BitSet();
        for (int i = 0; i < points.size(); i++) {
            if (vertices.contains(points.get(i))) {
                points.set(i, ExactNumber.clean(points.get(i).plus(by), ExactNumber.OF_INTERSECTIONS));
                edited.set(i);
            }
        }
        return new VertexEdit(solid, points, edited).hull();
    }

    /** Returns the convex hull with one more vertex, such as the middle of an edge pulled outwards. */
    public static BrushEdit<Solid> withVertex(Solid solid, Vec3 vertex) {
        List<Vec3> points = new ArrayList<>(vertices(solid));
        BitSet edited = new BitSet();
        edited.set(points.size());
        points.add(vertex);
        return new VertexEdit(solid, points, edited).hull();
    }

    private BrushEdit<Solid> hull() {
        List<ConvexHull.Side> sides = ConvexHull.of(points);
        if (sides.isEmpty()) {
            return BrushEdit.refused(BrushText.FLAT);
        } else if (edited.stream().anyMatch(i -> isNoVertex(i, sides))) {
            return BrushEdit.refused(BrushText.VERTEX_VANISHES);
        }
        HullFaces old = new HullFaces(List.of(solid), points);
        List<BitSet> corners = corners();
        List<PlaneFace> planes = new ArrayList<>();
        sides.forEach(side -> planes.add(old.plane(solid, side, like(side, old, corners))));
        return PlaneForm.rebuilt(PlaneForm.with(solid, solid.id(), planes));
    }

    private static boolean isNoVertex(int point, List<ConvexHull.Side> sides) {
        return sides.stream().filter(side -> side.on().get(point)).count() < FACES_AT_A_VERTEX;
    }

    /** Returns for each old face which points are its corners. */
    private List<BitSet> corners() {
        List<Vec3> before = vertices(solid);
        List<BitSet> corners = new ArrayList<>();
        for (ConvexPolyhedron.Face face : Brush.of(solid).shape().faces()) {
            BitSet of = new BitSet();
            face.polygon().forEach(corner -> of.set(before.indexOf(corner)));
            corners.add(of);
        }
        return corners;
    }

    /** Returns the old face with which the side shares most corners, among equals the one with the nearest normal. */
    private HullFaces.OldFace like(ConvexHull.Side side, HullFaces old, List<BitSet> corners) {
        HullFaces.OldFace best = null;
        double bestScore = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < corners.size(); i++) {
            BitSet shared = (BitSet) side.on().clone();
            shared.and(corners.get(i));
            HullFaces.OldFace candidate = old.all().get(i);
            double cosine = candidate.face().plane().normal().dot(side.plane().normal());
            double score = 4 * Math.min(FACES_AT_A_VERTEX, shared.cardinality()) + cosine;
            if (score > bestScore) {
                best = candidate;
                bestScore = score;
            }
        }
        return best;
    }
}
