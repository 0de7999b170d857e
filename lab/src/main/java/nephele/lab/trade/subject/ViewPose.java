package nephele.lab.trade.subject;

import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.portal.PortalTransform;
import nephele.engine.sim.player.PlayerPose;

/** The position and orientation of a view, and where the student report moves it as its eye goes through a portal. */
record ViewPose(Vec3 eye, Basis view) {
    /** The distance at which the report moves an eye. It does not give one; this is a body's radius plus the length of an arm. */
    static final double NEAR_METRES = 0.5;

    static ViewPose of(PlayerPose pose) {
        return new ViewPose(pose.eye(), pose.view());
    }

    /** Returns this view mapped through a portal. */
    ViewPose through(PortalTransform transform) {
        return new ViewPose(transform.point(eye), transform.basis(view));
    }

    /** Returns true if the student report moves an eye at this position. */
    static boolean isDue(Portal entry, Vec3 eye) {
        double height = entry.inFront(eye.x(), eye.y(), eye.z());
        return height >= 0
                && height <= NEAR_METRES
                && entry.aperture()
                        .contains(entry.across(eye.x(), eye.y(), eye.z()), entry.upward(eye.x(), eye.y(), eye.z()));
    }

    /**
     * Returns the report's pose in front of the middle of the other portal, {@link #NEAR_METRES} away, looking along its normal.
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
