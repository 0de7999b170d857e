package nephele.engine.scene.light.bake;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.bake.FaceFragment.Cover;

/** Divides a face by the footprints of other shapes on it. */
final class FaceCut {
    /** The height above a face, in metres, at which another shape is tested for covering it. */
    static final double PROBE_METRES = 1e-4;

    /** Fragments below this area are not cut off. */
    private static final double MIN_AREA_SQUARE_METRES = 1e-6;

    /**
     * Corners up to this distance behind a plane count as not behind it: half the tolerance of {@link PolygonClipping}, far
     * above rounding errors.
     */
    private static final double CLEAR_METRES = 5e-7;

    private FaceCut() {}

    /** A part of a face and its cover. */
    record Piece(Cover cover, List<Vec3> outline) {
        boolean isCovered() {
            return cover != Cover.NONE;
        }
    }

    /** Returns the whole face as one piece; it is hidden if a face of another shape contains it. */
    static List<Piece> whole(ConvexPolyhedron.Face face, List<ConvexPolyhedron> near) {
        for (ConvexPolyhedron other : near) {
            if (holds(other, face.polygon()) && coverBy(face.plane(), other) == Cover.TOUCHING) {
                return List.of(new Piece(Cover.TOUCHING, face.polygon()));
            }
        }
        return List.of(new Piece(Cover.NONE, face.polygon()));
    }

    private static boolean holds(ConvexPolyhedron shape, List<Vec3> corners) {
        for (ConvexPolyhedron.Face side : shape.faces()) {
            for (Vec3 corner : corners) {
                if (!(side.plane().signedDistance(corner) <= 2 * FaceFragments.WELD_METRES)) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Returns the pieces under the shapes' footprints and those beside them. */
    static List<Piece> cut(ConvexPolyhedron.Face face, List<ConvexPolyhedron> near) {
        List<Piece> pieces = List.of(new Piece(Cover.NONE, face.polygon()));
        for (ConvexPolyhedron other : near) {
            if (isClear(face, other)) {
                continue;
            }
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

    /** Returns true if the whole face is in front of one plane of the footprint, as for most shapes near a face. */
    private static boolean isClear(ConvexPolyhedron.Face face, ConvexPolyhedron other) {
        for (ConvexPolyhedron.Face side : other.faces()) {
            Plane plane = side.plane();
            double distance = lowered(plane, face.plane()) - CLEAR_METRES;
            boolean isBefore = true;
            for (int i = 0; i < face.polygon().size() && isBefore; i++) {
                Vec3 p = face.polygon().get(i);
                isBefore = plane.nx() * p.x() + plane.ny() * p.y() + plane.nz() * p.z() >= distance;
            }
            if (isBefore) {
                return true;
            }
        }
        return false;
    }

    private static double lowered(Plane p, Plane face) {
        double along = p.nx() * face.nx() + p.ny() * face.ny() + p.nz() * face.nz();
        return p.distance() - PROBE_METRES * along;
    }

    private static Cover coverBy(Plane face, ConvexPolyhedron other) {
        boolean touches = other.faces().stream()
                .map(ConvexPolyhedron.Face::plane)
                .anyMatch(p -> Math.abs(p.distance() + face.distance()) <= 2 * FaceFragments.WELD_METRES
                        && p.nx() * face.nx() + p.ny() * face.ny() + p.nz() * face.nz() < -1 + 1e-12);
        return touches ? Cover.TOUCHING : Cover.INSIDE;
    }

    /** Returns the other shape's planes, moved so that they cut the face where the shape is just above it. */
    private static List<Plane> footprint(Plane face, ConvexPolyhedron other) {
        List<Plane> planes = new ArrayList<>();
        for (ConvexPolyhedron.Face side : other.faces()) {
            Plane p = side.plane();
            planes.add(new Plane(p.nx(), p.ny(), p.nz(), lowered(p, face)));
        }
        return planes;
    }

    private static boolean covers(List<Plane> footprint, List<Vec3> outline) {
        List<Vec3> rest = outline;
        for (Plane plane : footprint) {
            rest = PolygonClipping.behind(rest, plane);
            if (rest.isEmpty()) {
                return false;
            }
        }
        return PolygonClipping.area(rest) > MIN_AREA_SQUARE_METRES;
    }

    private static void subtract(Piece piece, Cover cover, List<Plane> footprint, List<Piece> out) {
        List<Vec3> rest = piece.outline();
        for (Plane plane : footprint) {
            List<Vec3> outside = PolygonClipping.before(rest, plane);
            if (PolygonClipping.area(outside) > MIN_AREA_SQUARE_METRES) {
                out.add(new Piece(Cover.NONE, outside));
                rest = PolygonClipping.behind(rest, plane);
            }
        }
        out.add(new Piece(cover, rest));
    }
}
