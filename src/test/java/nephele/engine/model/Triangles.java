package nephele.engine.model;

import org.joml.Vector3d;

/** Corners, vertex normals and geometric normals of meshes, in double precision. */
public final class Triangles {
    private Triangles() {}

    public static Vector3d position(Mesh mesh, int vertex) {
        return row(mesh.positions(), vertex);
    }

    public static Vector3d vertexNormal(Mesh mesh, int vertex) {
        return row(mesh.normals(), vertex);
    }

    /**
     * Returns the normal; its length is twice the area.
     *
     * @param first index of the triangle's first corner in the indices
     */
    public static Vector3d normal(Mesh mesh, int first) {
        Vector3d a = position(mesh, mesh.indices()[first]);
        Vector3d ab = position(mesh, mesh.indices()[first + 1]).sub(a);
        Vector3d ac = position(mesh, mesh.indices()[first + 2]).sub(a);
        return ab.cross(ac);
    }

    private static Vector3d row(float[] values, int vertex) {
        return new Vector3d(values[3 * vertex], values[3 * vertex + 1], values[3 * vertex + 2]);
    }
}
