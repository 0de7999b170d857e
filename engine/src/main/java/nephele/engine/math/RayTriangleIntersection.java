package nephele.engine.math;

/**
 * Ray–triangle intersection without precomputation, by the signed volumes of the ray and the edges (Plücker
 * coordinates; Shoemake 1998). Both triangles at an edge compute the same products with opposite sign, and zero counts
 * as inside for both, so no ray passes between triangles that share the bits of their corners.
 */
public final class RayTriangleIntersection {
    private RayTriangleIntersection() {}

    /**
     * Returns the ray parameter of the hit from either side; infinite for a miss, negative behind the origin.
     *
     * @param corners nine numbers, beginning at {@code at}
     */
    public static double hitParameter(Ray ray, double[] corners, int at) {
        return hitParameter(
                ray.originX(),
                ray.originY(),
                ray.originZ(),
                ray.directionX(),
                ray.directionY(),
                ray.directionZ(),
                corners,
                at);
    }

    /** Returns the same for a ray given by its six numbers. */
    public static double hitParameter(
            double oX, double oY, double oZ, double dX, double dY, double dZ, double[] corners, int at) {
        double aX = corners[at] - oX;
        double aY = corners[at + 1] - oY;
        double aZ = corners[at + 2] - oZ;
        double bX = corners[at + 3] - oX;
        double bY = corners[at + 4] - oY;
        double bZ = corners[at + 5] - oZ;
        double cX = corners[at + 6] - oX;
        double cY = corners[at + 7] - oY;
        double cZ = corners[at + 8] - oZ;
        double u = dX * (bY * cZ - bZ * cY) + dY * (bZ * cX - bX * cZ) + dZ * (bX * cY - bY * cX);
        double v = dX * (cY * aZ - cZ * aY) + dY * (cZ * aX - cX * aZ) + dZ * (cX * aY - cY * aX);
        double w = dX * (aY * bZ - aZ * bY) + dY * (aZ * bX - aX * bZ) + dZ * (aX * bY - aY * bX);
        boolean mixedSigns = (u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0);
        double sum = u + v + w;
        if (mixedSigns || sum == 0) {
            return Double.POSITIVE_INFINITY;
        }
        double x = u * aX + v * bX + w * cX;
        double y = u * aY + v * bY + w * cY;
        double z = u * aZ + v * bZ + w * cZ;
        return (x * dX + y * dY + z * dZ) / (sum * (dX * dX + dY * dY + dZ * dZ));
    }

    /** Writes the barycentric weights of a point of the triangle's plane into {@code weights}; they sum to 1. */
    public static void barycentricWeights(Vec3 p, double[] corners, int at, double[] weights) {
        Vec3 a = new Vec3(corners[at] - p.x(), corners[at + 1] - p.y(), corners[at + 2] - p.z());
        Vec3 b = new Vec3(corners[at + 3] - p.x(), corners[at + 4] - p.y(), corners[at + 5] - p.z());
        Vec3 c = new Vec3(corners[at + 6] - p.x(), corners[at + 7] - p.y(), corners[at + 8] - p.z());
        Vec3 ofA = b.cross(c);
        Vec3 ofB = c.cross(a);
        Vec3 ofC = a.cross(b);
        Vec3 all = new Vec3(ofA.x() + ofB.x() + ofC.x(), ofA.y() + ofB.y() + ofC.y(), ofA.z() + ofB.z() + ofC.z());
        double square = all.dot(all);
        weights[0] = ofA.dot(all) / square;
        weights[1] = ofB.dot(all) / square;
        weights[2] = ofC.dot(all) / square;
    }
}
