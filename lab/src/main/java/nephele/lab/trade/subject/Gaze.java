package nephele.lab.trade.subject;

import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Passage;
import nephele.engine.sim.PlayerPose;

/** The position and orientation of a view. */
record Gaze(Vec3 eye, Basis view) {
    static Gaze of(PlayerPose pose) {
        return new Gaze(pose.eye(), pose.view());
    }

    /** Returns this view mapped through a portal. */
    Gaze through(Passage passage) {
        return new Gaze(passage.point(eye), passage.basis(view));
    }
}
