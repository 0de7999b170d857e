package nephele.engine.collision.rigid;

import nephele.engine.math.Vec3;

/** Moves bodies by one tick. Not for two threads at once: the working set is reused. */
public final class RigidStep {
    private final BodyTable table;
    private final Vec3 gravity;

    /** @param gravity m/s² */
    public RigidStep(BodyTable table, Vec3 gravity) {
        this.table = table;
        this.gravity = gravity;
    }

    /** The bodies {@code seconds} later: all that the tick depends on is in the arguments. */
    public Bodies step(Bodies before, Surroundings surroundings, Influences influences, double seconds) {
        double[] motion = before.motion().clone();
        for (int body = 0; body < table.size(); body++) {
            int at = Bodies.STRIDE * body;
            motion[at] += seconds * (motion[at + 7] + gravity.x() * seconds / 2);
            motion[at + 1] += seconds * (motion[at + 8] + gravity.y() * seconds / 2);
            motion[at + 2] += seconds * (motion[at + 9] + gravity.z() * seconds / 2);
            motion[at + 7] += gravity.x() * seconds;
            motion[at + 8] += gravity.y() * seconds;
            motion[at + 9] += gravity.z() * seconds;
        }
        return new Bodies(motion, before.rest().clone(), before.contacts(), BodyPassages.NONE);
    }
}
