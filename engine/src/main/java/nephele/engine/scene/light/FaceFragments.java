package nephele.engine.scene.light;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/**
 * Cuts faces along the footprints of the solids that stand on them. A wall on a floor separates the floor's light map
 * into inside and outside, so no interpolation carries light under the wall.
 */
public final class FaceFragments {
    /** Another solid covers a face where it is found this far above the face. */
    private static final double PROBE_METRES = 1e-4;

    /** Smaller cuts are not worth a fragment. */
    private static final double MIN_AREA_SQUARE_METRES = 1e-6;

    private static final double WELD_METRES = 1e-6;

    private record Piece(boolean isCovered, List<Vec3> outline) {}

    private final List<Brush> brushes;

    private FaceFragments(List<Brush> brushes) {
        this.brushes = brushes;
    }

    /** Fragments by brush, by face of its shape; together they cover each face exactly. */
    public static List<List<List<FaceFragment>>> of(List<Brush> brushes) {
        FaceFragments cutter = new FaceFragments(brushes);
        List<List<List<FaceFragment>>> byBrush = new ArrayList<>();
        for (Brush brush : brushes) {
            List<Brush> near = cutter.near(brush);
            List<List<FaceFragment>> byFace = new ArrayList<>();
            for (ConvexPolyhedron.Face face : brush.shape().faces()) {
                byFace.add(joined(cut(face, near)));
            }
            byBrush.add(byFace);
        }
        return byBrush;
    }

    private List<Brush> near(Brush brush) {
        Aabb reach = brush.shape().bounds().grown(PROBE_METRES);
        return brushes.stream()
                .filter(other -> other != brush && other.shape().bounds().overlaps(reach))
                .toList();
    }

    private static List<Piece> cut(ConvexPolyhedron.Face face, List<Brush> near) {
        List<Piece> pieces = List.of(new Piece(false, face.polygon()));
        for (Brush other : near) {
            List<Plane> footprint = footprint(face.plane(), other);
            List<Piece> next = new ArrayList<>();
            for (Piece piece : pieces) {
                if (piece.isCovered() || !covers(footprint, piece.outline())) {
                    next.add(piece);
                } else {
                    subtract(piece, footprint, next);
                }
            }
            pieces = next;
        }
        return pieces;
    }

    /** The other solid's planes, moved so that they cut the face where the solid is just above it. */
    private static List<Plane> footprint(Plane face, Brush other) {
        List<Plane> planes = new ArrayList<>();
        for (ConvexPolyhedron.Face side : other.shape().faces()) {
            Plane p = side.plane();
            double along = p.nx() * face.nx() + p.ny() * face.ny() + p.nz() * face.nz();
            planes.add(new Plane(p.nx(), p.ny(), p.nz(), p.distance() - PROBE_METRES * along));
        }
        return planes;
    }

    private static boolean covers(List<Plane> footprint, List<Vec3> outline) {
        List<Vec3> rest = outline;
        for (Plane plane : footprint) {
            rest = FacePolygon.behind(rest, plane);
            if (rest.isEmpty()) {
                return false;
            }
        }
        return FacePolygon.area(rest) > MIN_AREA_SQUARE_METRES;
    }

    private static void subtract(Piece piece, List<Plane> footprint, List<Piece> out) {
        List<Vec3> rest = piece.outline();
        for (Plane plane : footprint) {
            List<Vec3> outside = FacePolygon.before(rest, plane);
            if (FacePolygon.area(outside) > MIN_AREA_SQUARE_METRES) {
                out.add(new Piece(false, outside));
                rest = FacePolygon.behind(rest, plane);
            }
        }
        out.add(new Piece(true, rest));
    }

    /** Gives every fragment the corners that its neighbours have on its edges, bit by bit the same. */
    private static List<FaceFragment> joined(List<Piece> pieces) {
        List<Vec3> corners = new ArrayList<>();
        List<List<Vec3>> outlines = new ArrayList<>();
        for (Piece piece : pieces) {
            outlines.add(piece.outline().stream().map(p -> welded(corners, p)).toList());
        }
        List<FaceFragment> fragments = new ArrayList<>();
        for (int i = 0; i < pieces.size(); i++) {
            List<Vec3> outline = outlines.get(i);
            fragments.add(FaceFragment.of(pieces.get(i).isCovered(), outline, withNeighbours(outline, corners)));
        }
        return List.copyOf(fragments);
    }

    private static Vec3 welded(List<Vec3> corners, Vec3 p) {
        for (Vec3 known : corners) {
            if (known.toVector().distance(p.x(), p.y(), p.z()) <= WELD_METRES) {
                return known;
            }
        }
        corners.add(p);
        return p;
    }

    private static List<Vec3> withNeighbours(List<Vec3> outline, List<Vec3> corners) {
        List<Vec3> joined = new ArrayList<>();
        for (int i = 0; i < outline.size(); i++) {
            Vec3 a = outline.get(i);
            Vec3 b = outline.get((i + 1) % outline.size());
            joined.add(a);
            corners.stream()
                    .filter(p -> p != a && p != b && liesBetween(a, b, p))
                    .sorted((p, q) -> Double.compare(squareDistance(a, p), squareDistance(a, q)))
                    .forEach(joined::add);
        }
        return joined;
    }

    private static boolean liesBetween(Vec3 a, Vec3 b, Vec3 p) {
        double whole = Math.sqrt(squareDistance(a, b));
        double parts = Math.sqrt(squareDistance(a, p)) + Math.sqrt(squareDistance(p, b));
        // A corner h beside an edge of length L makes the way about 2h²/L longer.
        return parts - whole <= 2 * WELD_METRES * WELD_METRES / whole + 1e-12 * whole;
    }

    private static double squareDistance(Vec3 a, Vec3 b) {
        return a.toVector().distanceSquared(b.x(), b.y(), b.z());
    }
}
