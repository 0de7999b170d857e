package nephele.engine.render.pass.sky;

import org.joml.Vector3d;

/** The directions of a skybox's texels. */
final class SkyboxCube {
    /** For each face: outward direction, direction of growing s (right), direction of growing t (down the picture). */
    private static final double[][][] AXES = {
        {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
        {{-1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
        {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}},
        {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
        {{0, 0, 1}, {-1, 0, 0}, {0, -1, 0}},
        {{0, 0, -1}, {1, 0, 0}, {0, -1, 0}}
    };

    private SkyboxCube() {}

    /**
     * Returns the point of the cube of half side 1 at picture coordinates s, t in −1…1; beyond ±1 on the adjacent face.
     */
    static Vector3d point(int face, double s, double t) {
        double[][] a = AXES[face];
        return new Vector3d(
                a[0][0] + s * a[1][0] + t * a[2][0],
                a[0][1] + s * a[1][1] + t * a[2][1],
                a[0][2] + s * a[1][2] + t * a[2][2]);
    }

    /** Returns the face that a direction hits. */
    static int faceOf(Vector3d direction) {
        int best = 0;
        for (int face = 1; face < 6; face++) {
            if (along(direction, face, 0) > along(direction, best, 0)) {
                best = face;
            }
        }
        return best;
    }

    /** Returns the picture coordinate (axis 1: s, 2: t) in −1…1 of a direction on its face. */
    static double coordinate(Vector3d direction, int face, int axis) {
        return along(direction, face, axis) / along(direction, face, 0);
    }

    private static double along(Vector3d direction, int face, int axis) {
        double[] a = AXES[face][axis];
        return direction.dot(a[0], a[1], a[2]);
    }
}
