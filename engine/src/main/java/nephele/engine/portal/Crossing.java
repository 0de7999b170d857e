package nephele.engine.portal;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * When and where a moving point first enters an open portal. The point flies along p + v t + a t² / 2. A portal is
 * entered by passing from its front to behind it within the aperture, at a time in [0, end): the side decides, no timer,
 * so a way cut into pieces crosses as often as the whole. Reused for every query; the accessors speak of the last one.
 */
public final class Crossing {
    /** A point so little behind a portal's plane is there by rounding and counts as in front. */
    private static final double ROUNDING_METRES = 1e-9;

    private int portal = Portals.CLOSED;
    private double seconds;
    private final Vector3d place = new Vector3d();

    /** The portal that is entered. */
    public int portal() {
        return portal;
    }

    public double seconds() {
        return seconds;
    }

    /** Where, in the entry's space. */
    public Vector3dc place() {
        return place;
    }

    /** The earliest entry before {@code end} seconds; false for none. Of two at one time the lower index counts. */
    public boolean find(Portals portals, Vector3dc p, Vector3dc v, Vector3dc a, double end) {
        portal = Portals.CLOSED;
        seconds = end;
        for (int i = 0; i < portals.size(); i++) {
            if (portals.isOpen(i)) {
                consider(portals.portal(i), i, p, v, a);
            }
        }
        return portal != Portals.CLOSED;
    }

    private void consider(Portal candidate, int index, Vector3dc p, Vector3dc v, Vector3dc a) {
        double height = candidate.inFront(p.x(), p.y(), p.z());
        double speed = along(candidate, v);
        double t = descent(height, speed, along(candidate, a));
        if (!(t < seconds)) {
            return;
        }
        double half = t * t / 2;
        double x = p.x() + v.x() * t + a.x() * half;
        double y = p.y() + v.y() * t + a.y() * half;
        double z = p.z() + v.z() * t + a.z() * half;
        if (candidate.aperture().contains(candidate.across(x, y, z), candidate.upward(x, y, z))) {
            portal = index;
            seconds = t;
            place.set(x, y, z);
        }
    }

    private static double along(Portal portal, Vector3dc v) {
        return portal.normal().x() * v.x()
                + portal.normal().y() * v.y()
                + portal.normal().z() * v.z();
    }

    /** The time at which height + speed t + acceleration t² / 2 falls below zero, without cancellation; NaN for never. */
    static double descent(double height, double speed, double acceleration) {
        double root = Math.sqrt(speed * speed - 2 * acceleration * height);
        double t = speed > 0 ? (-root - speed) / acceleration : 2 * height / (root - speed);
        if (speed <= 0 && height <= 0 && height >= -ROUNDING_METRES) {
            return speed < 0 || acceleration < 0 ? 0 : Double.NaN;
        }
        return t >= 0 && root > 0 ? t : Double.NaN;
    }
}
