package nephele.engine.scene.dynamic;

import java.util.Arrays;
import nephele.engine.scene.dynamic.DynamicMesh.Range;

/**
 * Meshes of the bodies' shapes at unit size: an instance scales them, so that all sizes share one mesh. Round shapes
 * have several levels of detail.
 */
final class BodyMeshes {
    /** The number of sides of a round shape's equator, from the finest level of detail to the coarsest. */
    private static final int[] SIDES = {48, 24, 12};

    private BodyMeshes() {}

    /** Adds a box from −1 to 1 along each axis, with texture coordinates in the same range. */
    static Range box(DynamicMesh mesh) {
        int first = mesh.indexCount();
        mesh.tag(0, 0);
        for (int face = 0; face < 6; face++) {
            int axis = face / 2;
            double side = face % 2 == 0 ? 1 : -1;
            int[] corners = new int[4];
            for (int corner = 0; corner < 4; corner++) {
                // Counter-clockwise around +axis; reversed if the face points towards −axis.
                double a = (corner == 1 || corner == 2 ? 1 : -1) * side;
                double b = corner >= 2 ? 1 : -1;
                double[] p = new double[3];
                double[] n = new double[3];
                p[axis] = n[axis] = side;
                p[(axis + 1) % 3] = a;
                p[(axis + 2) % 3] = b;
                corners[corner] = mesh.vertex(p, n, a, b);
            }
            mesh.triangle(corners[0], corners[1], corners[2]);
            mesh.triangle(corners[0], corners[2], corners[3]);
        }
        return mesh.since(first);
    }

    /**
     * Adds spheres of radius 1, each in two halves, which an instance may move apart along y to make a capsule. v is
     * below ½ on the lower half and above it on the upper one.
     */
    static Range[] round(DynamicMesh mesh) {
        Range[] steps = new Range[SIDES.length];
        for (int i = 0; i < SIDES.length; i++) {
            steps[i] = sphere(mesh, SIDES[i]);
        }
        return steps;
    }

    private static Range sphere(DynamicMesh mesh, int sides) {
        int first = mesh.indexCount();
        mesh.tag(0, 0);
        int rows = sides / 2 + 2;
        int[] ring = new int[sides + 1];
        int[] below = new int[sides + 1];
        for (int row = 0; row < rows; row++) {
            boolean upper = row >= rows / 2;
            int step = upper ? row - 1 : row;
            double latitude = Math.PI * (step / (sides / 2.0) - 0.5);
            double v = upper ? 0.5 + 1e-4 + (step - sides / 4.0) / sides : 0.5 - 1e-4 - (sides / 4.0 - step) / sides;
            for (int i = 0; i <= sides; i++) {
                double longitude = 2 * Math.PI * i / sides;
                double[] p = {
                    Math.cos(latitude) * Math.sin(longitude),
                    Math.sin(latitude),
                    Math.cos(latitude) * Math.cos(longitude)
                };
                ring[i] = mesh.vertex(p, p, i / (double) sides, v);
            }
            if (row > 0) {
                band(mesh, below, ring);
            }
            System.arraycopy(ring, 0, below, 0, ring.length);
        }
        return mesh.since(first);
    }

    /** Adds the triangles between two rings of equally many vertices, the second above the first. */
    static void band(DynamicMesh mesh, int[] below, int[] above) {
        for (int i = 0; i + 1 < below.length; i++) {
            mesh.triangle(below[i], below[i + 1], above[i + 1]);
            mesh.triangle(below[i], above[i + 1], above[i]);
        }
    }

    /** Returns for each level of detail the greatest depth of its flat sides below the round surface, in radii. */
    static double[] flatness() {
        return Arrays.stream(SIDES)
                .mapToDouble(sides -> 1 - Math.cos(Math.PI / sides))
                .toArray();
    }
}
