package nephele.engine.model.file;

import org.joml.Vector3d;

/** Computes missing unit vertex normals: the mean of the triangle normals, weighted by the angle at the vertex. */
final class MissingNormals {
    private static final double VANISHING = 1e-12;

    private MissingNormals() {}

    /** Scales normals to unit length and computes those of length 0; a vertex without any area gets +y. */
    static void fill(float[] positions, float[] normals, int[] indices) {
        boolean[] missing = new boolean[positions.length / 3];
        boolean some = false;
        for (int i = 0; i < missing.length; i++) {
            missing[i] = !normalize(normals, 3 * i);
            some |= missing[i];
        }
        if (some) {
            compute(positions, normals, indices, missing);
        }
    }

    private static void compute(float[] positions, float[] normals, int[] indices, boolean[] missing) {
        double[] sums = new double[positions.length];
        for (int i = 0; i < indices.length; i += 3) {
            for (int corner = 0; corner < 3; corner++) {
                int vertex = indices[i + corner];
                if (missing[vertex]) {
                    addCorner(sums, positions, vertex, indices[i + (corner + 1) % 3], indices[i + (corner + 2) % 3]);
                }
            }
        }
        for (int i = 0; i < missing.length; i++) {
            if (missing[i]) {
                set(normals, 3 * i, new Vector3d(sums[3 * i], sums[3 * i + 1], sums[3 * i + 2]));
            }
        }
    }

    private static void addCorner(double[] sums, float[] positions, int at, int next, int last) {
        Vector3d a = edge(positions, at, next);
        Vector3d b = edge(positions, at, last);
        Vector3d normal = a.cross(b, new Vector3d());
        double length = normal.length();
        if (length == 0) {
            return;
        }
        normal.mul(StrictMath.atan2(length, a.dot(b)) / length);
        sums[3 * at] += normal.x;
        sums[3 * at + 1] += normal.y;
        sums[3 * at + 2] += normal.z;
    }

    private static Vector3d edge(float[] positions, int from, int to) {
        return new Vector3d(positions[3 * to], positions[3 * to + 1], positions[3 * to + 2])
                .sub(positions[3 * from], positions[3 * from + 1], positions[3 * from + 2]);
    }

    private static void set(float[] normals, int at, Vector3d sum) {
        if (sum.length() > VANISHING) {
            sum.normalize();
        } else {
            sum.set(0, 1, 0);
        }
        normals[at] = (float) sum.x;
        normals[at + 1] = (float) sum.y;
        normals[at + 2] = (float) sum.z;
    }

    /** Keeps a normal that has unit length to float precision, so that written meshes read back equal. */
    private static boolean normalize(float[] normals, int at) {
        double x = normals[at];
        double y = normals[at + 1];
        double z = normals[at + 2];
        double length = Math.sqrt(x * x + y * y + z * z);
        if (!(length > VANISHING)) {
            return false;
        }
        if (Math.abs(length - 1) > 1e-6) {
            normals[at] = (float) (x / length);
            normals[at + 1] = (float) (y / length);
            normals[at + 2] = (float) (z / length);
        }
        return true;
    }
}
