package nephele.lab.trade.subject;

import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.portal.PortalTransform;

/**
 * The student report's rule for going through a portal: an eye that comes near is moved in front of the other portal
 * and looks along its normal. It is kept for comparison.
 */
final class SourceTeleport {
    /** The report does not give a distance; this is a body's radius plus the length of an arm. */
    static final double NEAR_METRES = 0.5;

    private SourceTeleport() {}

    /** Returns true if the rule moves an eye at this position. */
    static boolean isDue(Portal entry, Vec3 eye) {
        double height = entry.inFront(eye.x(), eye.y(), eye.z());
        return height >= 0
                && height <= NEAR_METRES
                && entry.aperture()
                        .contains(entry.across(eye.x(), eye.y(), eye.z()), entry.upward(eye.x(), eye.y(), eye.z()));
    }

    /**
     * Returns the pose in front of the middle of the other portal, {@link #NEAR_METRES} away, looking along its normal.
     */
    static ViewPose alongNormal(Portal exit) {
        return new ViewPose(exit.world(0, 0, NEAR_METRES), ahead(exit));
    }

    /** Returns the same position with the view mapped through the portal, the smallest repair of the rule. */
    static ViewPose keepingView(PortalTransform transform, Portal exit, ViewPose before) {
        return new ViewPose(exit.world(0, 0, NEAR_METRES), transform.basis(before.view()));
    }

    private static Basis ahead(Portal exit) {
        Vec3 n = exit.normal();
        Vec3 back = n.negated();
        Vec3 r = exit.frame().right();
        return new Basis(r.negated(), exit.frame().up(), back);
    }
}
