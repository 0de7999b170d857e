package nephele.engine.scene;

import java.util.Arrays;
import java.util.List;
import nephele.engine.math.Basis;
import nephele.engine.math.Isometry;
import nephele.engine.math.Plane;
import nephele.engine.math.Reflection;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;

/**
 * A convex polygon in the world through which a view shows another view of it: a portal or a mirror. It is visible from
 * its front only, the side that {@code frame.back()} points to; its corners are counter-clockwise seen from there.
 * Immutable.
 */
public final class Opening {
    /** The value of {@link #portal} for a mirror. */
    public static final int NO_PORTAL = -1;

    /** The tint of an opening that loses no light. */
    private static final Vec3 CLEAR = new Vec3(1, 1, 1);

    private final int id;
    private final int partner;
    private final int portal;
    private final Vec3 centre;
    private final Basis frame;
    /** The corners' x and y along right and up of the frame, relative to the centre. */
    private final double[] corners;

    private final Isometry isometry;
    private final Plane exit;
    private final Vec3 tint;
    /**
     * The images of the centre and of the frame's right and up under the isometry; with the polygon they distinguish
     * one opening from another.
     */
    private final Vec3[] exitFrame;

    private Opening(
            int id,
            int partner,
            int portal,
            Vec3 centre,
            Basis frame,
            double[] corners,
            Isometry isometry,
            Plane exit,
            Vec3 tint) {
        this.id = id;
        this.partner = partner;
        this.portal = portal;
        this.centre = centre;
        this.frame = frame;
        this.corners = corners;
        this.isometry = isometry;
        this.exit = exit;
        this.tint = tint;
        exitFrame =
                new Vec3[] {isometry.point(centre), isometry.direction(frame.right()), isometry.direction(frame.up())};
    }

    /**
     * Makes the opening of a portal.
     *
     * @param index index of an open portal
     */
    static Opening ofPortal(int id, Portals portals, int index) {
        Portal portal = portals.portal(index);
        Aperture aperture = portal.aperture();
        double[] corners = new double[2 * aperture.corners()];
        for (int i = 0; i < aperture.corners(); i++) {
            corners[2 * i] = aperture.cornerX(i);
            corners[2 * i + 1] = aperture.cornerY(i);
        }
        Plane exit = portals.plane(portals.partner(index));
        int partner = id - index + portals.partner(index);
        return new Opening(
                id, partner, index, portal.centre(), portal.frame(), corners, portals.transform(index), exit, CLEAR);
    }

    /**
     * Makes the opening of a mirror.
     *
     * @param polygon its corners in the world, counter-clockwise seen from the front
     * @param normal unit length, towards the front
     * @param tint reflected share of the light, linear RGB
     */
    public static Opening ofMirror(int id, List<Vec3> polygon, Vec3 normal, Vec3 tint) {
        Vec3 centre = middle(polygon);
        Basis frame = Portal.facing(normal, new Vec3(0, 1, 0));
        double[] corners = new double[2 * polygon.size()];
        for (int i = 0; i < polygon.size(); i++) {
            Vector3d p = polygon.get(i).toVector().sub(centre.x(), centre.y(), centre.z());
            corners[2 * i] = p.dot(frame.right().toVector());
            corners[2 * i + 1] = p.dot(frame.up().toVector());
        }
        Plane plane = new Plane(normal.x(), normal.y(), normal.z(), normal.dot(centre));
        return new Opening(id, id, NO_PORTAL, centre, frame, corners, new Reflection(centre, normal), plane, tint);
    }

    private static Vec3 middle(List<Vec3> polygon) {
        Vec3 first = polygon.get(0);
        Vector3d sum = new Vector3d();
        polygon.forEach(p -> sum.add(p.x() - first.x(), p.y() - first.y(), p.z() - first.z()));
        return Vec3.of(sum.div(polygon.size()).add(first.x(), first.y(), first.z()));
    }

    /** Returns the index of the portal, or {@link #NO_PORTAL} for a mirror. */
    public int portal() {
        return portal;
    }

    /** Returns the world position of the centre, metres. */
    public Vec3 centre() {
        return centre;
    }

    /** Returns the orientation: right and up span the plane, back is the normal towards the front. */
    public Basis frame() {
        return frame;
    }

    /** Returns the map from a view in front of the opening to the view that is seen through it. */
    public Isometry isometry() {
        return isometry;
    }

    /** Returns the plane that cuts the view through the opening; only what is in front of it is visible. */
    public Plane exit() {
        return exit;
    }

    /** Returns the factor on the radiance that comes through the opening, linear RGB. */
    public Vec3 tint() {
        return tint;
    }

    /** Returns the signed distance in metres to the opening's plane, positive in front of it. */
    double inFront(double x, double y, double z) {
        Vec3 n = frame.back();
        return n.x() * (x - centre.x()) + n.y() * (y - centre.y()) + n.z() * (z - centre.z());
    }

    int corners() {
        return corners.length / 2;
    }

    double cornerX(int corner) {
        return corners[2 * corner];
    }

    double cornerY(int corner) {
        return corners[2 * corner + 1];
    }

    /**
     * Returns the greatest extent from the centre along a direction of the plane, in units of the direction's length.
     */
    public double reach(double x, double y) {
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < corners.length; i += 2) {
            most = Math.max(most, corners[i] * x + corners[i + 1] * y);
        }
        return most;
    }

    /** Returns true if this is the partner opening of {@code other}, which inverts its map. */
    boolean leadsBackThrough(Opening other) {
        return id == other.partner;
    }

    /** Returns true if a segment passes through the opening from its front to its back or ends in its plane. */
    boolean isPassed(Vector3d start, Vector3d end) {
        double before = inFront(start.x, start.y, start.z);
        double after = inFront(end.x, end.y, end.z);
        if (!(before > 0) || after > 0) {
            return false;
        }
        Vector3d at = start.lerp(end, before / (before - after), new Vector3d());
        at.sub(centre.x(), centre.y(), centre.z());
        return contains(at.dot(frame.right().toVector()), at.dot(frame.up().toVector()));
    }

    private boolean contains(double x, double y) {
        for (int i = 0, last = corners.length - 2; i < corners.length; last = i, i += 2) {
            double alongX = corners[i] - corners[last];
            double alongY = corners[i + 1] - corners[last + 1];
            if (alongX * (y - corners[last + 1]) - alongY * (x - corners[last]) < 0) {
                return false;
            }
        }
        return true;
    }

    /** Returns true if both have the same id, position, shape and target. */
    boolean isSameAs(Opening other) {
        return this == other
                || id == other.id
                        && centre.equals(other.centre)
                        && frame.equals(other.frame)
                        && Arrays.equals(corners, other.corners)
                        && Arrays.equals(exitFrame, other.exitFrame);
    }
}
