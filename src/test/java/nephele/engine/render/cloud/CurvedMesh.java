package nephele.engine.render.cloud;

import nephele.engine.math.Vec3;

/**
 * The twin of the mesh in {@code cloud-sheet.glsl}: (16 + 1)² vertices around the eye, 2√(R₂² − R₁²) wide, raised by R₁, lowered
 * by (x² + z²) / R₂; R₁ 100, R₂ 900, in units of a hundredth of its height. Rays are tested against all its triangles.
 *
 * @param heightMetres of its middle over the eye
 */
record CurvedMesh(double heightMetres) {
    private static final int DIVISIONS = 16;
    private static final double R1 = 100;
    private static final double R2 = 900;

    private double scale() {
        return heightMetres / R1;
    }

    private double place(int vertex) {
        double size = 2 * Math.sqrt(R2 * R2 - R1 * R1);
        return scale() * size * (vertex / (double) DIVISIONS - 0.5);
    }

    private Vec3 vertex(int i, int k) {
        double x = place(i);
        double z = place(k);
        return new Vec3(x, heightMetres - (x * x + z * z) / (R2 * scale()), z);
    }

    /** Returns the cosine between a ray from the eye and the mesh where they meet; 0 if they do not. */
    double cosine(Vec3 ray) {
        for (int n = 0; n < DIVISIONS * DIVISIONS; n++) {
            int i = n % DIVISIONS;
            int k = n / DIVISIONS;
            Vec3 low = vertex(i, k);
            Vec3 high = vertex(i + 1, k + 1);
            double cosine =
                    Math.max(cosine(ray, low, vertex(i + 1, k), high), cosine(ray, low, high, vertex(i, k + 1)));
            if (cosine > 0) {
                return cosine;
            }
        }
        return 0;
    }

    /** Möller and Trumbore 1997. */
    private static double cosine(Vec3 ray, Vec3 a, Vec3 b, Vec3 c) {
        Vec3 ab = b.minus(a);
        Vec3 ac = c.minus(a);
        Vec3 across = ray.cross(ac);
        double determinant = ab.dot(across);
        if (determinant == 0) {
            return 0;
        }
        double u = -a.dot(across) / determinant;
        Vec3 turned = a.scaled(-1).cross(ab);
        double v = ray.dot(turned) / determinant;
        double metres = ac.dot(turned) / determinant;
        boolean meets = u >= 0 && v >= 0 && u + v <= 1 && metres > 0;
        Vec3 normal = ab.cross(ac);
        return meets ? Math.abs(normal.dot(ray)) / normal.length() : 0;
    }

    /** Returns the height over the eye at a distance along x. */
    double height(double metres) {
        for (int i = 0; i < DIVISIONS; i++) {
            if (metres >= place(i) && metres <= place(i + 1)) {
                double share = (metres - place(i)) / (place(i + 1) - place(i));
                double from = vertex(i, DIVISIONS / 2).y();
                return from + share * (vertex(i + 1, DIVISIONS / 2).y() - from);
            }
        }
        return Double.NaN;
    }
}
