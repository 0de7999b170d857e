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
 * A convex polygon in the world through which a view sees another view of it: a portal or a mirror. It is seen from in
 * front only, where {@code frame.back()} points to; its corners go counter-clockwise there. Immutable.
 */
public final class Opening {
    /** The {@link #portal} of a mirror. */
    public static final int NO_PORTAL = -1;

    /** What an opening that keeps all light multiplies radiance by. */
    private static final Vec3 CLEAR = new Vec3(1, 1, 1);

    private final int id;
    private final int partner;
    private final int portal;
    private final Vec3 centre;
    private final Basis frame;
    /** x and y along right and up of the frame, from the centre. */
    private final double[] corners;

    private final Isometry isometry;
    private final Plane exit;
    private final Vec3 tint;
    /** Where the isometry leads the frame: with the polygon, what tells one opening from another. */
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
        exitFrame = new Vec3[] {
            Vec3.of(isometry.point(centre.toVector())),
            Vec3.of(isometry.direction(frame.right().toVector())),
            Vec3.of(isometry.direction(frame.up().toVector()))
        };
    }

    /** @param index of an open portal */
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
                id, partner, index, portal.centre(), portal.frame(), corners, portals.passage(index), exit, CLEAR);
    }

    /**
     * @param polygon its corners in the world, counter-clockwise seen from in front
     * @param normal unit length, towards where it is seen from
     * @param tint share of light that it reflects, linear RGB
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

    /** The index of the portal that this is, or {@link #NO_PORTAL}. */
    public int portal() {
        return portal;
    }

    public Vec3 centre() {
        return centre;
    }

    public Basis frame() {
        return frame;
    }

    /** From a view before it to the view that is seen through it. */
    public Isometry isometry() {
        return isometry;
    }

    /** Behind which the view through it sees nothing. */
    public Plane exit() {
        return exit;
    }

    /** What radiance that comes through it is multiplied by, linear RGB. */
    public Vec3 tint() {
        return tint;
    }

    /** Metres in front of its plane, negative behind it. */
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

    /** How far it reaches from its centre along a direction of its plane. */
    public double reach(double x, double y) {
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < corners.length; i += 2) {
            most = Math.max(most, corners[i] * x + corners[i + 1] * y);
        }
        return most;
    }

    /** Whether this undoes what {@code other} does. */
    boolean leadsBackThrough(Opening other) {
        return id == other.partner;
    }

    /** Whether a straight way goes through it, from in front to behind or into its plane. */
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

    /** Whether both have one id, lie at one place, have one shape and lead to one place. */
    boolean isSameAs(Opening other) {
        return this == other
                || id == other.id
                        && centre.equals(other.centre)
                        && frame.equals(other.frame)
                        && Arrays.equals(corners, other.corners)
                        && Arrays.equals(exitFrame, other.exitFrame);
    }
}
