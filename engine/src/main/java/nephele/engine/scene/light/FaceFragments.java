package nephele.engine.scene.light;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiFunction;
import nephele.engine.level.Brush;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.FaceFragment.Cover;

/**
 * Cuts faces along the footprints of the solids that stand on them. A wall on a floor separates the floor's light map
 * into inside and outside, so no interpolation carries light under the wall.
 */
public final class FaceFragments {
    /** Another solid covers a face where it is found this far above the face. */
    private static final double PROBE_METRES = 1e-4;

    /** Smaller cuts are not worth a fragment. */
    private static final double MIN_AREA_SQUARE_METRES = 1e-6;

    private record Piece(Cover cover, List<Vec3> outline) {
        boolean isCovered() {
            return cover != Cover.NONE;
        }
    }

    private final List<Brush> brushes;
    private final Neighbours neighbours;
    private final CornerWeld weld = new CornerWeld();

    private FaceFragments(List<Brush> brushes) {
        this.brushes = brushes;
        neighbours = Neighbours.of(brushes.stream().map(b -> b.shape().bounds()).toList(), PROBE_METRES);
    }

    /** Fragments by brush, by face of its shape; together they cover each face exactly. */
    public static List<List<List<FaceFragment>>> of(List<Brush> brushes) {
        return ofDistinct(brushes, FaceFragments::cut);
    }

    /** As {@link #of}, but every face stays whole: its neighbours' corners are put on its edges, or they hide all of it. */
    public static List<List<List<FaceFragment>>> uncut(List<Brush> brushes) {
        return ofDistinct(brushes, (face, near) -> List.of(new Piece(coverOfAll(face, near), face.polygon())));
    }

    /** Solids of the same shape at the same place have the same fragments: a face is never before its own copy. */
    private static List<List<List<FaceFragment>>> ofDistinct(
            List<Brush> brushes, BiFunction<ConvexPolyhedron.Face, List<Brush>, List<Piece>> divide) {
        Map<ConvexPolyhedron, Integer> numbers = new HashMap<>();
        List<Brush> distinct = new ArrayList<>();
        for (Brush brush : brushes) {
            if (numbers.putIfAbsent(brush.shape(), distinct.size()) == null) {
                distinct.add(brush);
            }
        }
        List<List<List<FaceFragment>>> fragments = new FaceFragments(distinct).fragments(divide);
        return brushes.stream()
                .map(brush -> fragments.get(numbers.get(brush.shape())))
                .toList();
    }

    private static Cover coverOfAll(ConvexPolyhedron.Face face, List<Brush> near) {
        boolean hidden = near.stream()
                .anyMatch(other -> holds(other, face.polygon()) && coverBy(face.plane(), other) == Cover.TOUCHING);
        return hidden ? Cover.TOUCHING : Cover.NONE;
    }

    private static boolean holds(Brush brush, List<Vec3> corners) {
        return brush.shape().faces().stream().map(ConvexPolyhedron.Face::plane).allMatch(plane -> corners.stream()
                .allMatch(corner -> plane.signedDistance(corner) <= 2 * CornerWeld.WELD_METRES));
    }

    private List<List<List<FaceFragment>>> fragments(
            BiFunction<ConvexPolyhedron.Face, List<Brush>, List<Piece>> divide) {
        List<List<Integer>> near = new ArrayList<>();
        List<List<List<Piece>>> pieces = new ArrayList<>();
        for (int brush = 0; brush < brushes.size(); brush++) {
            List<Integer> around = neighbours.of(brush);
            List<Brush> standing = around.stream().map(brushes::get).toList();
            near.add(around);
            pieces.add(brushes.get(brush).shape().faces().stream()
                    .map(face -> divide.apply(face, standing))
                    .map(parts -> around.isEmpty() ? parts : welded(parts))
                    .toList());
        }
        List<List<List<FaceFragment>>> byBrush = new ArrayList<>();
        for (int brush = 0; brush < brushes.size(); brush++) {
            byBrush.add(joined(brush, pieces, near.get(brush)));
        }
        return byBrush;
    }

    private List<Piece> welded(List<Piece> parts) {
        return parts.stream()
                .map(part -> new Piece(
                        part.cover(), part.outline().stream().map(weld::welded).toList()))
                .toList();
    }

    private static List<Piece> cut(ConvexPolyhedron.Face face, List<Brush> near) {
        List<Piece> pieces = List.of(new Piece(Cover.NONE, face.polygon()));
        for (Brush other : near) {
            List<Plane> footprint = footprint(face.plane(), other);
            List<Piece> next = new ArrayList<>();
            for (Piece piece : pieces) {
                if (piece.isCovered() || !covers(footprint, piece.outline())) {
                    next.add(piece);
                } else {
                    subtract(piece, coverBy(face.plane(), other), footprint, next);
                }
            }
            pieces = next;
        }
        return pieces;
    }

    private static Cover coverBy(Plane face, Brush other) {
        boolean touches = other.shape().faces().stream()
                .map(ConvexPolyhedron.Face::plane)
                .anyMatch(p -> Math.abs(p.distance() + face.distance()) <= 2 * CornerWeld.WELD_METRES
                        && p.nx() * face.nx() + p.ny() * face.ny() + p.nz() * face.nz() < -1 + 1e-12);
        return touches ? Cover.TOUCHING : Cover.INSIDE;
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

    private static void subtract(Piece piece, Cover cover, List<Plane> footprint, List<Piece> out) {
        List<Vec3> rest = piece.outline();
        for (Plane plane : footprint) {
            List<Vec3> outside = FacePolygon.before(rest, plane);
            if (FacePolygon.area(outside) > MIN_AREA_SQUARE_METRES) {
                out.add(new Piece(Cover.NONE, outside));
                rest = FacePolygon.behind(rest, plane);
            }
        }
        out.add(new Piece(cover, rest));
    }

    /** Gives every fragment the corners that its neighbours, on any face, have on its edges: bit by bit the same. */
    private List<List<FaceFragment>> joined(int brush, List<List<List<Piece>>> pieces, List<Integer> near) {
        List<ConvexPolyhedron.Face> faces = brushes.get(brush).shape().faces();
        if (near.isEmpty()) {
            return faces.stream()
                    .map(face -> List.of(FaceFragment.whole(face.polygon())))
                    .toList();
        }
        Set<Vec3> corners = new LinkedHashSet<>();
        addCorners(pieces.get(brush), corners);
        near.forEach(other -> addCorners(pieces.get(other), corners));
        List<List<FaceFragment>> byFace = new ArrayList<>();
        for (int face = 0; face < faces.size(); face++) {
            List<Vec3> onPlane = onPlane(faces.get(face).plane(), corners);
            byFace.add(pieces.get(brush).get(face).stream()
                    .map(p -> FaceFragment.of(p.cover(), p.outline(), withNeighbours(p.outline(), onPlane)))
                    .toList());
        }
        return byFace;
    }

    private static void addCorners(List<List<Piece>> ofBrush, Set<Vec3> corners) {
        ofBrush.forEach(face -> face.forEach(piece -> corners.addAll(piece.outline())));
    }

    private static List<Vec3> onPlane(Plane plane, Set<Vec3> corners) {
        return corners.stream()
                .filter(p -> Math.abs(plane.signedDistance(p)) <= 2 * CornerWeld.WELD_METRES)
                .toList();
    }

    private static List<Vec3> withNeighbours(List<Vec3> outline, List<Vec3> corners) {
        List<Vec3> joined = new ArrayList<>();
        for (int i = 0; i < outline.size(); i++) {
            Vec3 a = outline.get(i);
            Vec3 b = outline.get((i + 1) % outline.size());
            joined.add(a);
            corners.stream()
                    .filter(p -> !p.equals(a) && !p.equals(b) && liesBetween(a, b, p))
                    .sorted((p, q) -> Double.compare(squareDistance(a, p), squareDistance(a, q)))
                    .forEach(joined::add);
        }
        return joined;
    }

    private static boolean liesBetween(Vec3 a, Vec3 b, Vec3 p) {
        double whole = Math.sqrt(squareDistance(a, b));
        if (whole <= 2 * CornerWeld.WELD_METRES) {
            return false;
        }
        double parts = Math.sqrt(squareDistance(a, p)) + Math.sqrt(squareDistance(p, b));
        // A corner h beside an edge of length L makes the way about 2h²/L longer.
        return parts - whole <= 2 * CornerWeld.WELD_METRES * CornerWeld.WELD_METRES / whole + 1e-12 * whole;
    }

    private static double squareDistance(Vec3 a, Vec3 b) {
        return a.toVector().distanceSquared(b.x(), b.y(), b.z());
    }
}
