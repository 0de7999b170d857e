package nephele.engine.math;

import java.util.List;

/** Volume, thickness and areas of convex solids. */
public final class PolyhedronMeasure {
    private PolyhedronMeasure() {}

    /** Returns the volume in m³, as the sum of tetrahedra from one corner, so that the place does not matter. */
    public static double volumeCubicMetres(ConvexPolyhedron shape) {
        Vec3 origin = shape.vertices().get(0);
        double sixfold = 0;
        for (ConvexPolyhedron.Face face : shape.faces()) {
            List<Vec3> ring = face.polygon();
            Vec3 a = ring.get(0).minus(origin);
            for (int i = 2; i < ring.size(); i++) {
                Vec3 b = ring.get(i - 1).minus(origin);
                Vec3 c = ring.get(i).minus(origin);
                sixfold += a.dot(b.cross(c));
            }
        }
        return sixfold / 6;
    }

    /** Returns the least extent in metres perpendicular to a face. */
    public static double thicknessMetres(ConvexPolyhedron shape) {
        double thickness = Double.POSITIVE_INFINITY;
        for (ConvexPolyhedron.Face face : shape.faces()) {
            double depth = 0;
            for (Vec3 corner : shape.vertices()) {
                depth = Math.max(depth, -face.plane().signedDistance(corner));
            }
            thickness = Math.min(thickness, depth);
        }
        return thickness;
    }

    /** Returns the area of all faces in m². */
    public static double surfaceSquareMetres(ConvexPolyhedron shape) {
        return shape.faces().stream()
                .mapToDouble(face -> areaSquareMetres(face.polygon()))
                .sum();
    }

    /** Returns the area of a convex polygon in m². */
    public static double areaSquareMetres(List<Vec3> ring) {
        Vec3 doubled = Vec3.ZERO;
        Vec3 origin = ring.get(0);
        for (int i = 2; i < ring.size(); i++) {
            doubled =
                    doubled.plus(ring.get(i - 1).minus(origin).cross(ring.get(i).minus(origin)));
        }
        return doubled.length() / 2;
    }
}
