package nephele.engine.walk;

import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portals;

/**
 * A boom after a tick, in the space of the player's body.
 *
 * @param restVelocity of the eye, which it hangs on, in the last tick
 * @param extent how far it is out, 0 to 1
 */
record BoomState(CameraSpring spring, Vec3 restVelocity, double extent) {
    static final BoomState FOLDED = new BoomState(CameraSpring.AT_REST, Vec3.ZERO, 0);

    /** What has got out of the way lets it out no faster. */
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

    /** With nothing in the way. */
    BoomState after(double seconds, double wantedExtent) {
        double out = Math.min(wantedExtent, extent + EXTENDING_PER_SECOND * seconds);
        double in = Math.max(wantedExtent, extent - FOLDING_PER_SECOND * seconds);
        return new BoomState(spring.after(seconds), restVelocity, extent > wantedExtent ? in : out);
    }

    BoomState notBeyond(double free) {
        return free < extent ? new BoomState(spring, restVelocity, free) : this;
    }
}
