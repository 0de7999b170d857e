package nephele.lab.trade.subject;

import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Passage;
import nephele.engine.sim.PlayerPose;

/** From where one looks, and how. */
record Gaze(Vec3 eye, Basis view) {
    static Gaze of(PlayerPose pose) {
        return new Gaze(pose.eye(), pose.view());
    }

    /** As it would go on through a window. */
    Gaze through(Passage passage) {
        return new Gaze(passage.point(eye), passage.basis(view));
    }
}
