package nephele.host.playthrough;

import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portals;

/**
 * A boom after a tick, in the space of the player's body.
 *
 * @param restVelocity velocity of the eye, which carries the boom, in the last tick, m/s
 * @param extent extended fraction of the boom, 0 to 1
 */
record CameraBoomState(CameraSpring spring, Vec3 restVelocity, double extent) {
    static final CameraBoomState FOLDED = new CameraBoomState(CameraSpring.AT_REST, Vec3.ZERO, 0);

    /** Rate in extents at which the boom extends, also after an obstacle has gone. */
    static final double EXTENDING_EXTENTS_PER_SECOND = 1.6;

    private static final double FOLDING_EXTENTS_PER_SECOND = 3;

    CameraBoomState through(CrossingWord crossed, Portals portals) {
        Vec3 velocity = restVelocity;
        for (int i = 0; i < crossed.length(); i++) {
            velocity = portals.transform(crossed.entry(i)).direction(velocity);
        }
        return new CameraBoomState(spring.through(crossed, portals), velocity, extent);
    }

    CameraBoomState restingAt(Vec3 velocity) {
        return new CameraBoomState(spring.restTurnsFrom(restVelocity, velocity), velocity, extent);
    }

    /** Returns the state after a time without obstacles. */
    CameraBoomState after(double seconds, double wantedExtent) {
        double out = Math.min(wantedExtent, extent + EXTENDING_EXTENTS_PER_SECOND * seconds);
        double in = Math.max(wantedExtent, extent - FOLDING_EXTENTS_PER_SECOND * seconds);
        return new CameraBoomState(spring.after(seconds), restVelocity, extent > wantedExtent ? in : out);
    }

    CameraBoomState notBeyond(double free) {
        return free < extent ? new CameraBoomState(spring, restVelocity, free) : this;
    }
}
