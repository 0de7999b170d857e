package nephele.engine.walk;

import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portals;

/**
 * A boom after a tick, in the space of the player's body.
 *
 * @param restVelocity velocity of the eye, which carries the boom, in the last tick, m/s
 * @param extent extended share of the boom, 0 to 1
 */
record BoomState(CameraSpring spring, Vec3 restVelocity, double extent) {
    static final BoomState FOLDED = new BoomState(CameraSpring.AT_REST, Vec3.ZERO, 0);

    /** Rate in extents at which the boom extends, also after an obstacle has gone. */
    static final double EXTENDING_PER_SECOND = 1.6;

    private static final double FOLDING_PER_SECOND = 3;

    BoomState through(CrossingWord crossed, Portals portals) {
        Vec3 velocity = restVelocity;
        for (int i = 0; i < crossed.length(); i++) {
            velocity = portals.passage(crossed.entry(i)).direction(velocity);
        }
        return new BoomState(spring.through(crossed, portals), velocity, extent);
    }

    BoomState restingAt(Vec3 velocity) {
        return new BoomState(spring.restTurnsFrom(restVelocity, velocity), velocity, extent);
    }

    /** Returns the state after a time without obstacles. */
    BoomState after(double seconds, double wantedExtent) {
        double out = Math.min(wantedExtent, extent + EXTENDING_PER_SECOND * seconds);
        double in = Math.max(wantedExtent, extent - FOLDING_PER_SECOND * seconds);
        return new BoomState(spring.after(seconds), restVelocity, extent > wantedExtent ? in : out);
    }

    BoomState notBeyond(double free) {
        return free < extent ? new BoomState(spring, restVelocity, free) : this;
    }
}
