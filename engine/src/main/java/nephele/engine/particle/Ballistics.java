package nephele.engine.particle;

import nephele.engine.level.Emitter;
import org.joml.Vector3d;

/**
 * A drop that leaves a portal with another velocity than its final one: drag in proportion to the difference brings it
 * back to that, v(t) = v_f + (v_0 − v_f) e^(−kt) with k = g / |v_f|.
 */
final class Ballistics {
    private static final double FINAL_SPEED = Emitter.RAIN_METRES_PER_SECOND;
    private static final double DRAG_PER_SECOND = ParticleLaw.GRAVITY / FINAL_SPEED;

    private final Vector3d from = new Vector3d();
    private final Vector3d speed = new Vector3d();

    /** Begins at a place with a velocity; both are copied. */
    void begin(Vector3d place, Vector3d velocity) {
        from.set(place);
        speed.set(velocity);
    }

    Vector3d place(double seconds, Vector3d out) {
        double left = -Math.expm1(-DRAG_PER_SECOND * seconds) / DRAG_PER_SECOND;
        return out.set(
                from.x + speed.x * left,
                from.y - FINAL_SPEED * seconds + (speed.y + FINAL_SPEED) * left,
                from.z + speed.z * left);
    }

    Vector3d velocity(double seconds, Vector3d out) {
        double left = Math.exp(-DRAG_PER_SECOND * seconds);
        return out.set(speed.x * left, (speed.y + FINAL_SPEED) * left - FINAL_SPEED, speed.z * left);
    }
}
