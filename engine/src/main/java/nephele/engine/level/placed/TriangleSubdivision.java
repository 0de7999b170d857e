package nephele.engine.level.placed;

import nephele.engine.math.Vec3;

/**
 * Subdivides triangles into similar ones, each edge into the same number of parts, so that values computed at vertices
 * and interpolated become more accurate. Points on a shared edge have the same bits from both sides.
 */
final class TriangleSubdivision {
    private final WorldTriangles mesh;
    private final int parts;
    private final double[] positions;
    private final double[] normals;
    private final double[] texture;
    private final int[] vertices;
    private final double[] faceNormals;
    private int vertexCount;
    private int indexCount;

    private TriangleSubdivision(WorldTriangles mesh, int parts) {
        this.mesh = mesh;
        this.parts = parts;
        int ofTriangle = (parts + 1) * (parts + 2) / 2;
        positions = new double[3 * ofTriangle * mesh.count()];
        normals = new double[positions.length];
        texture = new double[2 * ofTriangle * mesh.count()];
        vertices = new int[3 * parts * parts * mesh.count()];
        faceNormals = new double[vertices.length];
    }

    /** @param parts the number of parts of each edge */
    static WorldTriangles of(WorldTriangles mesh, int parts) {
        if (parts <= 1) {
            return mesh;
        }
        TriangleSubdivision split = new TriangleSubdivision(mesh, parts);
        for (int triangle = 0; triangle < mesh.count(); triangle++) {
            split.add(triangle);
        }
        return new WorldTriangles(split.positions, split.normals, split.texture, split.vertices, split.faceNormals);
    }

    private void add(int triangle) {
        int first = vertexCount;
        for (int row = 0; row <= parts; row++) {
            for (int column = 0; column <= parts - row; column++) {
                addVertex(triangle, parts - row - column, column, row);
            }
        }
        for (int row = 0; row < parts; row++) {
            int below = first + row * (parts + 1) - row * (row - 1) / 2;
            int above = below + parts + 1 - row;
            for (int column = 0; column < parts - row; column++) {
                addTriangle(triangle, below + column, below + column + 1, above + column);
                if (column + 1 < parts - row) {
                    addTriangle(triangle, below + column + 1, above + column + 1, above + column);
                }
            }
        }
    }

    /** Adds a vertex with integer barycentric weights that add up to the number of parts. */
    private void addVertex(int triangle, int ofA, int ofB, int ofC) {
        Vec3 a = mesh.corner(triangle, 0);
        Vec3 b = mesh.corner(triangle, 1);
        Vec3 c = mesh.corner(triangle, 2);
        positions[3 * vertexCount] = (ofA * a.x() + ofB * b.x() + ofC * c.x()) / parts;
        positions[3 * vertexCount + 1] = (ofA * a.y() + ofB * b.y() + ofC * c.y()) / parts;
        positions[3 * vertexCount + 2] = (ofA * a.z() + ofB * b.z() + ofC * c.z()) / parts;
        Vec3 normal = mesh.faceNormal(triangle);
        normals[3 * vertexCount] = normal.x();
        normals[3 * vertexCount + 1] = normal.y();
        normals[3 * vertexCount + 2] = normal.z();
        texture[2 * vertexCount] =
                (ofA * mesh.s(triangle, 0) + ofB * mesh.s(triangle, 1) + ofC * mesh.s(triangle, 2)) / parts;
        texture[2 * vertexCount + 1] =
                (ofA * mesh.t(triangle, 0) + ofB * mesh.t(triangle, 1) + ofC * mesh.t(triangle, 2)) / parts;
        vertexCount++;
    }

    private void addTriangle(int of, int a, int b, int c) {
        System.arraycopy(mesh.faceNormals(), 3 * of, faceNormals, indexCount, 3);
        vertices[indexCount++] = a;
        vertices[indexCount++] = b;
        vertices[indexCount++] = c;
    }
}
