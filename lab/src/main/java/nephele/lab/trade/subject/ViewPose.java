package nephele.lab.trade.subject;

import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.portal.PortalTransform;
import nephele.engine.sim.player.PlayerPose;

/** The position and orientation of a view. */
record ViewPose(Vec3 eye, Basis view) {
    static ViewPose of(PlayerPose pose) {
        return new ViewPose(pose.eye(), pose.view());
    }

    /** Returns this view mapped through a portal. */
    ViewPose through(PortalTransform transform) {
        return new ViewPose(transform.point(eye), transform.basis(view));
    }
}
