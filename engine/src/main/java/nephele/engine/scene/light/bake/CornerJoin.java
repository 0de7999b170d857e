package nephele.engine.scene.light.bake;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.bake.FaceCut.Piece;

/** Inserts the corners of neighbouring fragments, on any face, into a fragment's edges, with the same bits. */
final class CornerJoin {
    private final ConvexPolyhedron shape;
    private final Aabb around;
    private final double reachMetres;
    private final Set<Vec3> corners = new LinkedHashSet<>();

    /**
     * Starts with the corners of one shape.
     *
     * @param pieces the shape's welded pieces, by face
     */
    CornerJoin(ConvexPolyhedron shape, List<List<Piece>> pieces) {
        this.shape = shape;
        Aabb box = shape.bounds();
        double longest = box.maxX() - box.minX() + box.maxY() - box.minY() + box.maxZ() - box.minZ();
        // A corner counts as between two others if its distance to their edge is at most a micrometre plus 0.71e-6 of
        // the edge's length.
        reachMetres = 10 * CornerWeld.WELD_METRES + 1e-6 * longest;
        around = box.grown(reachMetres);
        add(pieces);
    }

    /** Adds the corners of a shape nearby. */
    void add(List<List<Piece>> pieces) {
        for (List<Piece> face : pieces) {
            for (Piece piece : face) {
                for (Vec3 p : piece.outline()) {
                    if (holds(p)) {
                        corners.add(p);
                    }
                }
            }
        }
    }

    private boolean holds(Vec3 p) {
        return around.minX() <= p.x()
                && p.x() <= around.maxX()
                && around.minY() <= p.y()
                && p.y() <= around.maxY()
                && around.minZ() <= p.z()
                && p.z() <= around.maxZ();
    }

    List<List<FaceFragment>> joined(List<List<Piece>> pieces) {
        List<List<FaceFragment>> byFace = new ArrayList<>();
        for (int face = 0; face < pieces.size(); face++) {
            List<Vec3> onPlane = onPlane(shape.faces().get(face).plane());
            byFace.add(pieces.get(face).stream()
                    .map(p -> FaceFragment.of(p.cover(), p.outline(), withNeighbours(p.outline(), onPlane)))
                    .toList());
        }
        return byFace;
    }

    private List<Vec3> onPlane(Plane plane) {
        List<Vec3> on = new ArrayList<>();
        for (Vec3 p : corners) {
            if (Math.abs(plane.signedDistance(p)) <= 2 * CornerWeld.WELD_METRES) {
                on.add(p);
            }
        }
        return on;
    }

    private List<Vec3> withNeighbours(List<Vec3> outline, List<Vec3> corners) {
        List<Vec3> joined = new ArrayList<>();
        List<Vec3> between = new ArrayList<>();
        for (int i = 0; i < outline.size(); i++) {
            Vec3 a = outline.get(i);
            Vec3 b = outline.get((i + 1) % outline.size());
            joined.add(a);
            for (Vec3 p : corners) {
                if (isNear(a, b, p) && !p.equals(a) && !p.equals(b) && liesBetween(a, b, p)) {
                    between.add(p);
                }
            }
            between.sort((p, q) -> Double.compare(squareDistance(a, p), squareDistance(a, q)));
            joined.addAll(between);
            between.clear();
        }
        return joined;
    }

    /** Returns true if a point is in the bounding box of an edge. */
    private boolean isNear(Vec3 a, Vec3 b, Vec3 p) {
        return isWithin(a.x(), b.x(), p.x()) && isWithin(a.y(), b.y(), p.y()) && isWithin(a.z(), b.z(), p.z());
    }

    private boolean isWithin(double a, double b, double p) {
        return Math.min(a, b) - reachMetres <= p && p <= Math.max(a, b) + reachMetres;
    }

    private static boolean liesBetween(Vec3 a, Vec3 b, Vec3 p) {
        double whole = Math.sqrt(squareDistance(a, b));
        if (whole <= 2 * CornerWeld.WELD_METRES) {
            return false;
        }
        double parts = Math.sqrt(squareDistance(a, p)) + Math.sqrt(squareDistance(p, b));
        // A corner at the distance h from an edge of length L makes the path about 2h²/L longer.
        return parts - whole <= 2 * CornerWeld.WELD_METRES * CornerWeld.WELD_METRES / whole + 1e-12 * whole;
    }

    private static double squareDistance(Vec3 a, Vec3 b) {
        return a.toVector().distanceSquared(b.x(), b.y(), b.z());
    }
}
