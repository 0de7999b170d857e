package nephele.engine.model.bound;

import nephele.engine.math.Vec3;

/** The distance from a point to a triangle. */
public final class TriangleDistance {
    private TriangleDistance() {}

    /**
     * Returns the distance of the nearest point of a triangle, which lies inside it or on one of its edges.
     *
     * @param triangle three corners; without an area, its edges count
     */
    public static double of(Vec3[] triangle, Vec3 point) {
        Vec3 normal = triangle[1].minus(triangle[0]).cross(triangle[2].minus(triangle[0]));
        double area = normal.length();
        double nearest = Double.POSITIVE_INFINITY;
        boolean isInside = area > 0;
        for (int i = 0; i < 3; i++) {
            Vec3 edge = triangle[(i + 1) % 3].minus(triangle[i]);
            Vec3 from = point.minus(triangle[i]);
            isInside &= normal.cross(edge).dot(from) >= 0;
            nearest = Math.min(nearest, toEdge(edge, from));
        }
        return isInside ? Math.abs(normal.dot(point.minus(triangle[0]))) / area : nearest;
    }

    /** @param from the point, from where the edge starts */
    private static double toEdge(Vec3 edge, Vec3 from) {
        double square = edge.dot(edge);
        double share = square > 0 ? Math.max(0, Math.min(1, from.dot(edge) / square)) : 0;
        return from.addScaled(-share, edge).length();
    }
}
