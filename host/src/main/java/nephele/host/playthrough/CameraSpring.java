package nephele.host.playthrough;

import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;

/**
 * The lag of a camera behind its rest position, on a critically damped spring: x'' + 2 ω x' + ω² x = 0 relative to the
 * rest position, solved in closed form: x(t) = (x₀ + (v₀ + ω x₀) t) exp(−ω t). Any division of the time gives the same
 * result, and there is no lag behind a rest position of constant velocity.
 *
 * @param lag metres
 * @param velocity of the lag, m/s
 */
record CameraSpring(Vec3 lag, Vec3 velocity) {
    static final CameraSpring AT_REST = new CameraSpring(Vec3.ZERO, Vec3.ZERO);

    private static final double RATE_PER_SECOND = 12;

    CameraSpring after(double seconds) {
        double decay = Math.exp(-RATE_PER_SECOND * seconds);
        Vector3d pull = velocity.toVector().fma(RATE_PER_SECOND, lag.toVector());
        Vector3d moved = lag.toVector().fma(seconds, pull).mul(decay);
        Vector3d slowed =
                velocity.toVector().fma(-RATE_PER_SECOND * seconds, pull).mul(decay);
        return new CameraSpring(Vec3.of(moved), Vec3.of(slowed));
    }

    /** Returns the spring after a change of the rest position's velocity, which the camera does not follow at once. */
    CameraSpring restTurnsFrom(Vec3 before, Vec3 now) {
        return new CameraSpring(
                lag, Vec3.of(velocity.toVector().add(before.toVector()).sub(now.toVector())));
    }

    /** Returns the spring mapped through portals. */
    CameraSpring through(CrossingWord crossed, Portals portals) {
        CameraSpring there = this;
        for (int i = 0; i < crossed.length(); i++) {
            var transform = portals.transform(crossed.entry(i));
            there = new CameraSpring(transform.direction(there.lag), transform.direction(there.velocity));
        }
        return there;
    }
}
