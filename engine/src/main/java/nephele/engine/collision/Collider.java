package nephele.engine.collision;

import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/**
 * A solid convex obstacle: a polyhedron, or a segment with a radius around it. It is stored relative to its own centre,
 * so that a level a thousand kilometres from the origin keeps the precision of one at the origin.
 */
public final class Collider implements SupportPoints {
    private final ColliderShape form;
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
        this(solidId, new ColliderShape.Solid(shape), shape);
    }

    /** Makes a {@link TriangleCollider} from its four corners. */
    Collider(String solidId, Vec3[] sheet) {
        this(solidId, new ColliderShape.Sheet(sheet), TriangleCollider.shape(sheet));
    }

    private Collider(String solidId, ColliderShape form, ConvexPolyhedron shape) {
        this.solidId = solidId;
        this.form = form;
        bounds = shape.bounds();
        radiusMetres = 0;
        centre = bounds.centre();
        vertices = relativeVertices(shape.vertices(), centre);
        planes = relativePlanes(shape.faces(), centre);
        edges = form.edges(vertices);
    }

    /** Makes the set of all points within a radius of a segment: a capsule, or a sphere when the ends coincide. */
    private Collider(String solidId, Vec3 centre, Vec3 halfAxis, double radiusMetres) {
        this.solidId = solidId;
        this.centre = centre;
        this.radiusMetres = radiusMetres;
        form = new ColliderShape.Round(halfAxis);
        vertices = new double[] {-halfAxis.x(), -halfAxis.y(), -halfAxis.z(), halfAxis.x(), halfAxis.y(), halfAxis.z()};
        planes = new double[0];
        edges = form.edges(vertices);
        bounds = Aabb.around(
                        centre,
                        new Vec3(2 * Math.abs(halfAxis.x()), 2 * Math.abs(halfAxis.y()), 2 * Math.abs(halfAxis.z())))
                .grown(radiusMetres);
    }

    /** Returns a capsule about its centre, its axis from −{@code halfAxis} to +{@code halfAxis}; a sphere for zero. */
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
        return form.polyhedron();
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
