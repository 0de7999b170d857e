package nephele.engine.collision;

import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/**
 * A solid convex obstacle: a polyhedron, or a segment with a radius around it. It is stored relative to its own centre:
 * a level a thousand kilometres out keeps the precision of one at the origin.
 */
public final class Collider implements ConvexPoints {
    /** The corners of a {@link ThinSheet}, whose shape is made when it is asked for; {@code null} for others. */
    private final Vec3[] sheet;

    private ConvexPolyhedron shape;
    private final String solidId;
    private final Vec3 centre;
    private final double[] vertices;
    private final double[] planes;
    private final double[] edges;
    private final Aabb bounds;
    private final double radiusMetres;
    /** Made when the first body comes near. */
    private ContactHull contactHull;

    public Collider(String solidId, ConvexPolyhedron shape) {
        this.solidId = solidId;
        this.shape = shape;
        sheet = null;
        bounds = shape.bounds();
        radiusMetres = 0;
        centre = bounds.centre();
        vertices = relativeVertices(shape.vertices(), centre);
        planes = relativePlanes(shape.faces(), centre);
        edges = edgeDirections(shape.faces());
    }

    /** A {@link ThinSheet}: meshes have many, and few are ever cut or touched by a body. */
    Collider(String solidId, Vec3[] sheet) {
        this.solidId = solidId;
        this.sheet = sheet;
        ConvexPolyhedron made = ThinSheet.shape(sheet);
        bounds = made.bounds();
        radiusMetres = 0;
        centre = bounds.centre();
        vertices = relativeVertices(made.vertices(), centre);
        planes = relativePlanes(made.faces(), centre);
        edges = edgesOf(vertices);
    }

    /** The six edges between four corners. */
    private static double[] edgesOf(double[] four) {
        int[] pairs = {0, 1, 1, 2, 2, 0, 0, 3, 1, 3, 2, 3};
        double[] directions = new double[18];
        for (int i = 0; i < 18; i++) {
            int from = pairs[i / 3 * 2];
            int to = pairs[i / 3 * 2 + 1];
            directions[i] = four[3 * to + i % 3] - four[3 * from + i % 3];
        }
        return directions;
    }

    /** Everything within a radius of a segment: a capsule, or a sphere where the ends are one point. */
    private Collider(String solidId, Vec3 centre, Vec3 halfAxis, double radiusMetres) {
        this.solidId = solidId;
        this.centre = centre;
        this.radiusMetres = radiusMetres;
        shape = null;
        sheet = null;
        vertices = new double[] {-halfAxis.x(), -halfAxis.y(), -halfAxis.z(), halfAxis.x(), halfAxis.y(), halfAxis.z()};
        planes = new double[0];
        edges = new double[] {halfAxis.x(), halfAxis.y(), halfAxis.z()};
        bounds = Aabb.around(
                        centre,
                        new Vec3(2 * Math.abs(halfAxis.x()), 2 * Math.abs(halfAxis.y()), 2 * Math.abs(halfAxis.z())))
                .grown(radiusMetres);
    }

    /** A capsule whose axis runs from −{@code halfAxis} to +{@code halfAxis} about its centre; a sphere for zero. */
    public static Collider capsule(String solidId, Vec3 centre, Vec3 halfAxis, double radiusMetres) {
        return new Collider(solidId, centre, halfAxis, radiusMetres);
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

    /** The plane's distance is taken at a corner of the face, where it is exact although the plane's own is large. */
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

    /** Each edge once or twice (as two faces see it), as an unnormalised direction. */
    private static double[] edgeDirections(List<ConvexPolyhedron.Face> faces) {
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

    /** For contact points of bodies. */
    public ContactHull contactHull() {
        if (contactHull == null) {
            contactHull = new ContactHull(this);
        }
        return contactHull;
    }

    public String solidId() {
        return solidId;
    }

    /** {@code null} for a round one. */
    public ConvexPolyhedron shape() {
        if (shape == null && sheet != null) {
            shape = ThinSheet.shape(sheet);
        }
        return shape;
    }

    public Aabb bounds() {
        return bounds;
    }

    /** How far the surface lies outside the hull of the vertices. */
    double radiusMetres() {
        return radiusMetres;
    }

    /** What {@link #vertex}, {@link #plane} and every local offset are relative to. */
    public Vec3 centre() {
        return centre;
    }

    /** Whether a point of the world lies strictly inside. */
    boolean holds(double x, double y, double z) {
        for (int i = 0; i < faces(); i++) {
            if (inFrontOf(i, x - centre.x(), y - centre.y(), z - centre.z()) >= 0) {
                return false;
            }
        }
        return true;
    }

    int faces() {
        return planes.length / 4;
    }

    /** Components 0–2 are the outward unit normal of a face, 3 is its distance from the centre. */
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

    /** The signed distance of a point, relative to the centre, from the plane of a face. */
    double inFrontOf(int face, double x, double y, double z) {
        int i = 4 * face;
        return planes[i] * x + planes[i + 1] * y + planes[i + 2] * z - planes[i + 3];
    }
}
