package nephele.engine.math;

import java.util.ArrayList;
import java.util.List;

/**
 * A convex solid cut in two by a plane. Every face is clipped by Sutherland and Hodgman (1974); a lid closes the
 * section. A corner nearer to the plane than {@link #ON_PLANE_METRES} counts as on it, so no thinner part results. Both
 * parts have the same bits along the cut, faces keep their plane index, and the lid has {@link #CAP}.
 *
 * @param behind the part behind the plane, {@code null} if empty
 * @param inFront the part in front of the plane, {@code null} if empty
 */
public record PolyhedronCut(ConvexPolyhedron behind, ConvexPolyhedron inFront) {
    /** The plane index of the face that a cut adds. */
    public static final int CAP = -1;

    /** Far above the rounding of a plane 1000 km from the origin, far below the collision skin of a body. */
    public static final double ON_PLANE_METRES = 1e-7;

    private static final double SAME_CORNER_METRES = 1e-9;

    /** Cuts a solid. If the plane does not cross it, one part is the solid itself and the other {@code null}. */
    public static PolyhedronCut of(ConvexPolyhedron solid, Plane plane) {
        double least = 0;
        double most = 0;
        for (Vec3 corner : solid.vertices()) {
            double d = plane.signedDistance(corner);
            least = Math.min(least, d);
            most = Math.max(most, d);
        }
        if (most <= ON_PLANE_METRES) {
            return new PolyhedronCut(solid, null);
        }
        if (least >= -ON_PLANE_METRES) {
            return new PolyhedronCut(null, solid);
        }
        List<Vec3> section = section(solid, plane);
        if (section.size() < 3) {
            return -least > most ? new PolyhedronCut(solid, null) : new PolyhedronCut(null, solid);
        }
        Plane opposite = plane.opposite();
        return new PolyhedronCut(part(solid, plane, section), part(solid, opposite, section));
    }

    private static ConvexPolyhedron part(ConvexPolyhedron solid, Plane plane, List<Vec3> section) {
        List<ConvexPolyhedron.Face> faces = new ArrayList<>();
        for (ConvexPolyhedron.Face face : solid.faces()) {
            List<Vec3> polygon = clipped(face.polygon(), plane);
            if (polygon.size() >= 3) {
                faces.add(new ConvexPolyhedron.Face(face.planeIndex(), face.plane(), polygon));
            }
        }
        faces.add(new ConvexPolyhedron.Face(CAP, plane, ConvexPolyhedron.counterClockwise(plane, section)));
        List<Vec3> corners = new ArrayList<>();
        for (ConvexPolyhedron.Face face : faces) {
            face.polygon().forEach(corner -> addOnce(corners, corner));
        }
        return new ConvexPolyhedron(List.copyOf(faces), List.copyOf(corners), Aabb.of(corners));
    }

    /** Returns the part of a polygon behind the plane; empty if only its boundary touches the plane. */
    private static List<Vec3> clipped(List<Vec3> polygon, Plane plane) {
        List<Vec3> kept = new ArrayList<>();
        boolean reachesBehind = false;
        Vec3 before = polygon.get(polygon.size() - 1);
        double beforeD = plane.signedDistance(before);
        for (Vec3 corner : polygon) {
            double d = plane.signedDistance(corner);
            if (crosses(beforeD, d)) {
                addOnce(kept, between(before, beforeD, corner, d));
            }
            if (d <= ON_PLANE_METRES) {
                addOnce(kept, corner);
                reachesBehind |= d < -ON_PLANE_METRES;
            }
            before = corner;
            beforeD = d;
        }
        return reachesBehind ? kept : List.of();
    }

    private static List<Vec3> section(ConvexPolyhedron solid, Plane plane) {
        List<Vec3> section = new ArrayList<>();
        for (ConvexPolyhedron.Face face : solid.faces()) {
            List<Vec3> polygon = face.polygon();
            Vec3 before = polygon.get(polygon.size() - 1);
            double beforeD = plane.signedDistance(before);
            for (Vec3 corner : polygon) {
                double d = plane.signedDistance(corner);
                if (crosses(beforeD, d)) {
                    addOnce(section, between(before, beforeD, corner, d));
                } else if (Math.abs(d) <= ON_PLANE_METRES) {
                    addOnce(section, corner);
                }
                before = corner;
                beforeD = d;
            }
        }
        return section;
    }

    private static boolean crosses(double a, double b) {
        return Math.min(a, b) < -ON_PLANE_METRES && Math.max(a, b) > ON_PLANE_METRES;
    }

    /** Interpolates in an order that depends on neither the edge's direction nor the side kept, so that bits agree. */
    private static Vec3 between(Vec3 a, double atA, Vec3 b, double atB) {
        boolean forward = isFirst(a, b);
        Vec3 from = forward ? a : b;
        Vec3 to = forward ? b : a;
        double t = Math.abs(forward ? atA : atB) / (Math.abs(atA) + Math.abs(atB));
        return from.lerp(to, t);
    }

    private static boolean isFirst(Vec3 a, Vec3 b) {
        return a.x() != b.x() ? a.x() < b.x() : a.y() != b.y() ? a.y() < b.y() : a.z() < b.z();
    }

    private static void addOnce(List<Vec3> corners, Vec3 corner) {
        for (Vec3 other : corners) {
            if (Math.abs(other.x() - corner.x()) <= SAME_CORNER_METRES
                    && Math.abs(other.y() - corner.y()) <= SAME_CORNER_METRES
                    && Math.abs(other.z() - corner.z()) <= SAME_CORNER_METRES) {
                return;
            }
        }
        corners.add(corner);
    }
}
