package nephele.engine.model.bound;

import nephele.engine.math.Vec3;

/** The exact test whether two triangles have a point in common. */
public final class TrianglePair {
    private TrianglePair() {}

    /**
     * Returns whether two triangles touch: no axis separates them. Convex polygons in space are separated by a normal of
     * theirs, by the cross product of an edge of each, or, in one plane, by a perpendicular of an edge in it (Gottschalk
     * 1996, "Separating axis theorem").
     *
     * @param a three corners
     * @param b three corners
     */
    public static boolean touch(Vec3[] a, Vec3[] b) {
        Vec3 normalA = a[1].minus(a[0]).cross(a[2].minus(a[0]));
        Vec3 normalB = b[1].minus(b[0]).cross(b[2].minus(b[0]));
        if (separates(normalA, a, b) || separates(normalB, a, b)) {
            return false;
        }
        for (int i = 0; i < 3; i++) {
            Vec3 edgeA = a[(i + 1) % 3].minus(a[i]);
            Vec3 edgeB = b[(i + 1) % 3].minus(b[i]);
            if (separates(edgeA.cross(normalA), a, b) || separates(edgeB.cross(normalB), a, b)) {
                return false;
            }
            for (int j = 0; j < 3; j++) {
                if (separates(edgeA.cross(b[(j + 1) % 3].minus(b[j])), a, b)) {
                    return false;
                }
            }
        }
        return true;
    }

    private static boolean separates(Vec3 axis, Vec3[] a, Vec3[] b) {
        double a0 = axis.dot(a[0]);
        double a1 = axis.dot(a[1]);
        double a2 = axis.dot(a[2]);
        double b0 = axis.dot(b[0]);
        double b1 = axis.dot(b[1]);
        double b2 = axis.dot(b[2]);
        return Math.max(a0, Math.max(a1, a2)) < Math.min(b0, Math.min(b1, b2))
                || Math.max(b0, Math.max(b1, b2)) < Math.min(a0, Math.min(a1, a2));
    }
}
