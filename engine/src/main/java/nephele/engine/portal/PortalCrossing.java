package nephele.engine.portal;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The first entry of a moving point into an open portal. The point moves along p + v t + a t² / 2. It enters a portal
 * by passing from its front to behind it within the aperture, at a time in [0, end). Only the side of the plane
 * decides, without a timer, so that a path cut into pieces crosses as often as the whole. Reused for every query; the
 * accessors describe the last one.
 */
public final class PortalCrossing {
    /** Depth up to which a point behind a portal's plane counts as in front: rounding error. */
    private static final double ROUNDING_METRES = 1e-9;

    private int portal = Portals.CLOSED;
    private double seconds;
    private final Vector3d place = new Vector3d();

    /** Returns the index of the portal that is entered, {@link Portals#CLOSED} for none. */
    public int portal() {
        return portal;
    }

    /** Returns the time of the entry, in the unit of {@code end}. */
    public double seconds() {
        return seconds;
    }

    /** Returns the place of the entry, in the entry's space. */
    public Vector3dc place() {
        return place;
    }

    /**
     * Finds the earliest entry before {@code end} seconds; returns false for none. Of two at one time the lower index
     * counts.
     */
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

    /**
     * Returns the time at which height + speed t + acceleration t² / 2 falls below zero, without cancellation; NaN for
     * never.
     */
    static double descent(double height, double speed, double acceleration) {
        double root = Math.sqrt(speed * speed - 2 * acceleration * height);
        double t = speed > 0 ? (-root - speed) / acceleration : 2 * height / (root - speed);
        if (speed <= 0 && height <= 0 && height >= -ROUNDING_METRES) {
            return speed < 0 || acceleration < 0 ? 0 : Double.NaN;
        }
        return t >= 0 && root > 0 ? t : Double.NaN;
    }
}
