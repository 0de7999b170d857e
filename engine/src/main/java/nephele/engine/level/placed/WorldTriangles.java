package nephele.engine.level.placed;

import java.util.Arrays;
import nephele.engine.math.Aabb;
import nephele.engine.math.Directions;
import nephele.engine.math.Normals;
import nephele.engine.math.Vec3;
import nephele.engine.model.Mesh;
import org.joml.Matrix3d;
import org.joml.Matrix3dc;
import org.joml.Matrix4dc;
import org.joml.Vector3d;

/**
 * A mesh's triangles in the world, counter-clockwise seen from outside also if mirrored, without those of zero area.
 *
 * @param positions x, y, z of each vertex of the mesh
 * @param normals unit normal of each vertex, x, y, z
 * @param textureCoordinates s, t of each vertex, t = 0 at the picture's top row
 * @param vertices three indices for each triangle
 * @param faceNormals x, y, z of each triangle: the unit normal of its plane
 */
public record WorldTriangles(
        double[] positions, double[] normals, double[] textureCoordinates, int[] vertices, double[] faceNormals) {
    static final WorldTriangles NONE =
            new WorldTriangles(new double[0], new double[0], new double[0], new int[0], new double[0]);

    /** Least ratio of height to longest edge; the normal of a flatter triangle would be decided by rounding. */
    private static final double LEAST_HEIGHT = 1e-6;

    /** Cosine above which a vertex's normal is that of its triangle: 0.08°, more than the rounding of files. */
    private static final double SAME_NORMAL = 0.999999;

    public static WorldTriangles of(Mesh mesh, Matrix4dc worldFromModel) {
        Matrix3d linear = new Matrix3d(worldFromModel);
        double[] positions = positions(mesh, worldFromModel);
        double[] normals = normals(mesh, linear);
        double[] texture = new double[mesh.textureCoordinates().length];
        for (int i = 0; i < texture.length; i++) {
            double given = mesh.textureCoordinates()[i];
            texture[i] = i % 2 == 0 ? given : 1 - given;
        }
        boolean flips = Normals.flipsWinding(linear);
        int[] vertices = new int[mesh.indices().length];
        double[] faceNormals = new double[vertices.length];
        int kept = 0;
        for (int at = 0; at < vertices.length; at += 3) {
            int a = mesh.indices()[at];
            int b = mesh.indices()[flips ? at + 2 : at + 1];
            int c = mesh.indices()[flips ? at + 1 : at + 2];
            Vec3 normal = faceNormal(positions, a, b, c);
            if (normal != null) {
                vertices[kept] = a;
                vertices[kept + 1] = b;
                vertices[kept + 2] = c;
                faceNormals[kept] = normal.x();
                faceNormals[kept + 1] = normal.y();
                faceNormals[kept + 2] = normal.z();
                kept += 3;
            }
        }
        return new WorldTriangles(
                positions, normals, texture, Arrays.copyOf(vertices, kept), Arrays.copyOf(faceNormals, kept));
    }

    private static double[] positions(Mesh mesh, Matrix4dc worldFromModel) {
        double[] positions = new double[mesh.positions().length];
        Vector3d p = new Vector3d();
        for (int i = 0; i < positions.length; i += 3) {
            p.set(mesh.positions()[i], mesh.positions()[i + 1], mesh.positions()[i + 2]);
            worldFromModel.transformPosition(p).get(positions, i);
        }
        return positions;
    }

    private static double[] normals(Mesh mesh, Matrix3dc linear) {
        double[] normals = new double[mesh.normals().length];
        for (int i = 0; i < normals.length; i += 3) {
            Vec3 given = new Vec3(mesh.normals()[i], mesh.normals()[i + 1], mesh.normals()[i + 2]);
            Vec3 n = Normals.transformed(linear, given);
            normals[i] = n.x();
            normals[i + 1] = n.y();
            normals[i + 2] = n.z();
        }
        return normals;
    }

    /** Returns {@code null} for a triangle of nearly zero area. */
    private static Vec3 faceNormal(double[] p, int a, int b, int c) {
        Vec3 ab = between(p, a, b);
        Vec3 ac = between(p, a, c);
        Vec3 doubled = ab.cross(ac);
        double longest = Math.max(Math.max(square(ab), square(ac)), square(between(p, b, c)));
        boolean hasArea = doubled.length() > LEAST_HEIGHT * longest;
        return hasArea ? Directions.unit(doubled) : null;
    }

    private static Vec3 between(double[] p, int a, int b) {
        return new Vec3(p[3 * b] - p[3 * a], p[3 * b + 1] - p[3 * a + 1], p[3 * b + 2] - p[3 * a + 2]);
    }

    private static double square(Vec3 v) {
        return v.dot(v);
    }

    public int count() {
        return vertices.length / 3;
    }

    /**
     * Returns a corner's position.
     *
     * @param corner 0 to 2
     */
    public Vec3 corner(int triangle, int corner) {
        int at = 3 * vertices[3 * triangle + corner];
        return new Vec3(positions[at], positions[at + 1], positions[at + 2]);
    }

    public Vec3 faceNormal(int triangle) {
        return new Vec3(faceNormals[3 * triangle], faceNormals[3 * triangle + 1], faceNormals[3 * triangle + 2]);
    }

    /**
     * Returns the normal of the smooth surface at a corner; the triangle's own normal if the file's points behind the
     * triangle.
     */
    public Vec3 normal(int triangle, int corner) {
        Vec3 own = ofVertex(vertices[3 * triangle + corner]);
        Vec3 face = faceNormal(triangle);
        return own.dot(face) > 0 ? own : face;
    }

    private Vec3 ofVertex(int vertex) {
        return new Vec3(normals[3 * vertex], normals[3 * vertex + 1], normals[3 * vertex + 2]);
    }

    public double s(int triangle, int corner) {
        return textureCoordinates[2 * vertices[3 * triangle + corner]];
    }

    public double t(int triangle, int corner) {
        return textureCoordinates[2 * vertices[3 * triangle + corner] + 1];
    }

    /** Returns true if every vertex normal is that of its triangle, so that no triangle stands for a curved surface. */
    public boolean isFaceted() {
        for (int triangle = 0; triangle < count(); triangle++) {
            for (int corner = 0; corner < 3; corner++) {
                if (normal(triangle, corner).dot(faceNormal(triangle)) < SAME_NORMAL) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Returns the length of the longest edge; 0 without triangles. */
    double longestEdge() {
        double longest = 0;
        for (int i = 0; i < vertices.length; i++) {
            int next = i % 3 == 2 ? i - 2 : i + 1;
            longest = Math.max(longest, square(between(positions, vertices[i], vertices[next])));
        }
        return Math.sqrt(longest);
    }

    /** Returns the bounds of the triangles; empty if there are none. */
    public Aabb bounds() {
        double[] least = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] most = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int vertex : vertices) {
            for (int axis = 0; axis < 3; axis++) {
                least[axis] = Math.min(least[axis], positions[3 * vertex + axis]);
                most[axis] = Math.max(most[axis], positions[3 * vertex + axis]);
            }
        }
        return new Aabb(least[0], least[1], least[2], most[0], most[1], most[2]);
    }

    /** Returns nine numbers for each triangle: x, y, z of its corners. */
    public double[] corners() {
        double[] corners = new double[3 * vertices.length];
        for (int i = 0; i < vertices.length; i++) {
            System.arraycopy(positions, 3 * vertices[i], corners, 3 * i, 3);
        }
        return corners;
    }

    /**
     * Subdivides triangles into similar ones, each edge into the same number of parts, so that values computed at vertices
     * and interpolated become more accurate. Points on a shared edge have the same bits from both sides.
     */
    static final class TriangleSubdivision {
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
}
