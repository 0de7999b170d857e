package nephele.engine.scene.dynamic;

import nephele.engine.scene.dynamic.DynamicMesh.Builder;

/**
 * A superellipsoid (Barr 1981, "Superquadrics and Angle-Preserving Transformations"), tapered along y. The parts of the
 * player's character consist of these.
 *
 * @param centre metres
 * @param half half sides, metres
 * @param roundness exponents along the height and around the y axis: 1 an ellipsoid, near 0 a box
 * @param taper fraction by which the top is wider than the middle, and the bottom narrower
 */
record Superellipsoid(double[] centre, double[] half, double[] roundness, double taper) {
    private static final double NUDGE = 1e-4;

    static Superellipsoid at(double x, double y, double z) {
        return new Superellipsoid(new double[] {x, y, z}, new double[] {1, 1, 1}, new double[] {1, 1}, 0);
    }

    Superellipsoid size(double halfX, double halfY, double halfZ) {
        return new Superellipsoid(centre, new double[] {halfX, halfY, halfZ}, roundness, taper);
    }

    /**
     * Sets the exponents of roundness.
     *
     * @param upright along the height
     * @param around around the y axis
     */
    Superellipsoid edges(double upright, double around) {
        return new Superellipsoid(centre, half, new double[] {upright, around}, taper);
    }

    Superellipsoid tapered(double fraction) {
        return new Superellipsoid(centre, half, roundness, fraction);
    }

    /**
     * Adds the triangles to a mesh.
     *
     * @param sides number around the y axis; half as many rows, at least 4
     */
    void addTo(Builder mesh, int sides) {
        int rows = Math.max(4, sides / 2);
        int[] below = new int[sides + 1];
        int[] ring = new int[sides + 1];
        for (int row = 0; row <= rows; row++) {
            double latitude = Math.PI * ((double) row / rows - 0.5);
            for (int i = 0; i <= sides; i++) {
                double longitude = 2 * Math.PI * i / sides;
                double v = row / (double) rows;
                ring[i] = mesh.vertex(point(latitude, longitude), normal(latitude, longitude), i / (double) sides, v);
            }
            if (row > 0) {
                BodyMeshes.band(mesh, below, ring);
            }
            System.arraycopy(ring, 0, below, 0, ring.length);
        }
    }

    private double[] point(double latitude, double longitude) {
        double radius = power(Math.cos(latitude), roundness[0]);
        double y = power(Math.sin(latitude), roundness[0]);
        double wide = radius * (1 + taper * y);
        return new double[] {
            centre[0] + half[0] * wide * power(Math.sin(longitude), roundness[1]),
            centre[1] + half[1] * y,
            centre[2] + half[2] * wide * power(Math.cos(longitude), roundness[1])
        };
    }

    /** Returns the normal by finite differences; at a pole it uses the ring next to it. */
    private double[] normal(double latitude, double longitude) {
        double steep = Math.max(-Math.PI / 2 + 0.02, Math.min(Math.PI / 2 - 0.02, latitude));
        double[] east = difference(point(steep, longitude + NUDGE), point(steep, longitude - NUDGE));
        double[] north = difference(point(steep + NUDGE, longitude), point(steep - NUDGE, longitude));
        double[] n = {
            east[1] * north[2] - east[2] * north[1],
            east[2] * north[0] - east[0] * north[2],
            east[0] * north[1] - east[1] * north[0]
        };
        double length = Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        if (length < 1e-30) {
            return new double[] {0, Math.signum(latitude), 0};
        }
        return new double[] {n[0] / length, n[1] / length, n[2] / length};
    }

    private static double[] difference(double[] a, double[] b) {
        return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }

    static double power(double x, double exponent) {
        return Math.signum(x) * Math.pow(Math.abs(x), exponent);
    }
}
