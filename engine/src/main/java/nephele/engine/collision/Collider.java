package nephele.engine.collision;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.Gjk.SupportPoints;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Directions;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/**
 * A solid convex obstacle: a polyhedron, a triangle of a mesh with a flat pyramid below it, or a segment with a radius
 * around it. It is stored relative to its own centre,
 * so that a level a thousand kilometres from the origin keeps the precision of one at the origin.
 */
public final class Collider implements SupportPoints {
    /** Greatest depth of the pyramid below a triangle; less for small triangles. */
    static final double TRIANGLE_DEPTH_METRES = 0.02;

    private static final double DEPTH_FRACTION = 0.25;
    /** The corners of the pyramid's faces, the triangle first. */
    private static final int[][] PYRAMID_FACES = {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}};
    /** The ends of the pyramid's edges. */
    private static final int[] PYRAMID_EDGES = {0, 1, 1, 2, 2, 0, 0, 3, 1, 3, 2, 3};

    /** {@code null} for a triangle, a sphere or a capsule. */
    private final ConvexPolyhedron polyhedron;
    /**
     * The corners of a triangle and the apex below; {@code null} for others. There are many and few need the polyhedron,
     * so it is built on each request.
     */
    private final Vec3[] pyramid;

    private final String solidId;
    private final Vec3 centre;
    private final double[] vertices;
    private final double[] planes;
    private final double[] edges;
    private final Aabb bounds;
    private final double radiusMetres;
    /** Built on first use. */
    private ContactHull contactHull;

    /** Makes a collider from a polyhedron in world coordinates, in metres. */
    public Collider(String solidId, ConvexPolyhedron shape) {
        this(solidId, shape, null, shape);
    }

    private Collider(String solidId, ConvexPolyhedron polyhedron, Vec3[] pyramid, ConvexPolyhedron shape) {
        this.solidId = solidId;
        this.polyhedron = polyhedron;
        this.pyramid = pyramid;
        bounds = shape.bounds();
        radiusMetres = 0;
        centre = bounds.centre();
        vertices = relativeVertices(shape.vertices(), centre);
        planes = relativePlanes(shape.faces(), centre);
        edges = pyramid == null ? edges(shape.faces()) : edges(vertices);
    }

    /** Makes the set of all points within a radius of a segment: a capsule, or a sphere when the ends coincide. */
    private Collider(String solidId, Vec3 centre, Vec3 halfAxis, double radiusMetres) {
        this.solidId = solidId;
        this.centre = centre;
        this.radiusMetres = radiusMetres;
        polyhedron = null;
        pyramid = null;
        vertices = new double[] {-halfAxis.x(), -halfAxis.y(), -halfAxis.z(), halfAxis.x(), halfAxis.y(), halfAxis.z()};
        planes = new double[0];
        edges = new double[] {halfAxis.x(), halfAxis.y(), halfAxis.z()};
        bounds = Aabb.around(
                        centre,
                        new Vec3(2 * Math.abs(halfAxis.x()), 2 * Math.abs(halfAxis.y()), 2 * Math.abs(halfAxis.z())))
                .grown(radiusMetres);
    }

    /** Returns a capsule about its centre, its axis from −{@code halfAxis} to +{@code halfAxis}; a sphere for zero. */
    public static Collider capsule(String solidId, Vec3 centre, Vec3 halfAxis, double radiusMetres) {
        return new Collider(solidId, centre, halfAxis, radiusMetres);
    }

    /** Returns each triangle of a mesh as a solid. */
    static List<Collider> triangles(String id, WorldTriangles mesh) {
        List<Collider> sheets = new ArrayList<>(mesh.count());
        for (int i = 0; i < mesh.count(); i++) {
            sheets.add(triangle(id, mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2), mesh.faceNormal(i)));
        }
        return sheets;
    }

    /**
     * Returns a triangle as a solid: a flat pyramid below it. Its sides slope inwards from the triangle's edges, so that
     * neighbours in one plane join like abutting floors. Sweeps are continuous, so that no speed passes through it.
     *
     * @param normal unit normal of the side on which the corners are counter-clockwise
     */
    static Collider triangle(String id, Vec3 a, Vec3 b, Vec3 c, Vec3 normal) {
        Vec3[] corners = {a, b, c, null};
        corners[3] = apex(corners, normal);
        return new Collider(id, null, corners, pyramid(corners));
    }

    /** Returns the apex below the triangle's incentre, where the three sides are equally steep. */
    private static Vec3 apex(Vec3[] p, Vec3 normal) {
        double a = p[2].minus(p[1]).length();
        double b = p[0].minus(p[2]).length();
        double c = p[1].minus(p[0]).length();
        double around = a + b + c;
        Vec3 doubled = p[1].minus(p[0]).cross(p[2].minus(p[0]));
        double depth = Math.min(TRIANGLE_DEPTH_METRES, DEPTH_FRACTION * doubled.length() / around);
        return new Vec3(
                (a * p[0].x() + b * p[1].x() + c * p[2].x()) / around - depth * normal.x(),
                (a * p[0].y() + b * p[1].y() + c * p[2].y()) / around - depth * normal.y(),
                (a * p[0].z() + b * p[1].z() + c * p[2].z()) / around - depth * normal.z());
    }

    /** Returns the pyramid with four faces, the triangle first. */
    private static ConvexPolyhedron pyramid(Vec3[] p) {
        List<ConvexPolyhedron.Face> made = new ArrayList<>();
        for (int i = 0; i < PYRAMID_FACES.length; i++) {
            List<Vec3> ring = List.of(p[PYRAMID_FACES[i][0]], p[PYRAMID_FACES[i][1]], p[PYRAMID_FACES[i][2]]);
            Vec3 n = ring.get(1).minus(ring.get(0)).cross(ring.get(2).minus(ring.get(0)));
            Vec3 unit = Directions.unit(n.x(), n.y(), n.z());
            made.add(new ConvexPolyhedron.Face(i, Plane.through(unit, ring.get(0)), ring));
        }
        List<Vec3> vertices = List.of(p);
        return new ConvexPolyhedron(List.copyOf(made), vertices, Aabb.of(vertices));
    }

    private static double[] relativeVertices(List<Vec3> points, Vec3 centre) {
        double[] relative = new double[3 * points.size()];
        for (int i = 0; i < points.size(); i++) {
            relative[3 * i] = points.get(i).x() - centre.x();
            relative[3 * i + 1] = points.get(i).y() - centre.y();
            relative[3 * i + 2] = points.get(i).z() - centre.z();
        }
        return relative;
    }

    /**
     * Takes each plane's distance at a corner of its face, where it is exact even if the plane's own distance is large.
     */
    private static double[] relativePlanes(List<ConvexPolyhedron.Face> faces, Vec3 centre) {
        double[] relative = new double[4 * faces.size()];
        for (int i = 0; i < faces.size(); i++) {
            Plane plane = faces.get(i).plane();
            Vec3 corner = faces.get(i).polygon().get(0);
            relative[4 * i] = plane.nx();
            relative[4 * i + 1] = plane.ny();
            relative[4 * i + 2] = plane.nz();
            relative[4 * i + 3] = plane.nx() * (corner.x() - centre.x())
                    + plane.ny() * (corner.y() - centre.y())
                    + plane.nz() * (corner.z() - centre.z());
        }
        return relative;
    }

    /** Returns the direction of each edge of the faces, of any length: twice when two faces share it. */
    private static double[] edges(List<ConvexPolyhedron.Face> faces) {
        double[] directions =
                new double[3 * faces.stream().mapToInt(f -> f.polygon().size()).sum()];
        int at = 0;
        for (ConvexPolyhedron.Face face : faces) {
            for (int i = 0; i < face.polygon().size(); i++) {
                Vec3 a = face.polygon().get(i);
                Vec3 b = face.polygon().get((i + 1) % face.polygon().size());
                directions[at++] = b.x() - a.x();
                directions[at++] = b.y() - a.y();
                directions[at++] = b.z() - a.z();
            }
        }
        return directions;
    }

    /** Returns the directions of the six edges between the four corners of a pyramid. */
    private static double[] edges(double[] vertices) {
        double[] directions = new double[18];
        for (int i = 0; i < 18; i++) {
            int from = PYRAMID_EDGES[i / 3 * 2];
            int to = PYRAMID_EDGES[i / 3 * 2 + 1];
            directions[i] = vertices[3 * to + i % 3] - vertices[3 * from + i % 3];
        }
        return directions;
    }

    /**
     * Returns the form used for contact points of bodies; built on the first call, which is not thread-safe.
     *
     * @throws IllegalStateException for a sphere or a capsule
     */
    public ContactHull contactHull() {
        if (contactHull == null) {
            contactHull = new ContactHull(this);
        }
        return contactHull;
    }

    /** Returns the id of the level object that this collider was made from. */
    public String solidId() {
        return solidId;
    }

    /**
     * Returns the polyhedron in world coordinates.
     *
     * @throws IllegalStateException for a sphere or a capsule
     */
    public ConvexPolyhedron shape() {
        if (polyhedron == null && pyramid == null) {
            throw new IllegalStateException(
                    "a sphere or a capsule has no faces; only static solids are cut or lain on");
        }
        return polyhedron == null ? pyramid(pyramid) : polyhedron;
    }

    /** Returns the bounding box in world coordinates. */
    public Aabb bounds() {
        return bounds;
    }

    /** Returns the distance of the surface outside the convex hull of the vertices. */
    double radiusMetres() {
        return radiusMetres;
    }

    /** Returns the origin of {@link #vertex}, {@link #plane} and every local offset. */
    public Vec3 centre() {
        return centre;
    }

    /** Returns true if a point in world coordinates is strictly inside. */
    boolean containsStrictly(double x, double y, double z) {
        for (int i = 0; i < faces(); i++) {
            if (inFrontOf(i, x - centre.x(), y - centre.y(), z - centre.z()) >= 0) {
                return false;
            }
        }
        return true;
    }

    /** Returns three numbers for each vertex, relative to the centre; the caller must not change them. */
    double[] vertices() {
        return vertices;
    }

    /** Returns four numbers for each face, as {@link #plane} gives them. */
    double[] planes() {
        return planes;
    }

    int faces() {
        return planes.length / 4;
    }

    /** Returns a component of a face's plane: 0–2 the outward unit normal, 3 its distance from the centre. */
    double plane(int face, int component) {
        return planes[4 * face + component];
    }

    int edges() {
        return edges.length / 3;
    }

    double edge(int edge, int axis) {
        return edges[3 * edge + axis];
    }

    @Override
    public double vertex(int vertex, int axis) {
        return vertices[3 * vertex + axis];
    }

    @Override
    public int farthest(double x, double y, double z) {
        int best = 0;
        double bestDot = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < vertices.length; i += 3) {
            double dot = vertices[i] * x + vertices[i + 1] * y + vertices[i + 2] * z;
            if (dot > bestDot) {
                bestDot = dot;
                best = i / 3;
            }
        }
        return best;
    }

    /** Returns the signed distance of a point, relative to the centre, from the plane of a face. */
    double inFrontOf(int face, double x, double y, double z) {
        int i = 4 * face;
        return planes[i] * x + planes[i + 1] * y + planes[i + 2] * z - planes[i + 3];
    }
}
