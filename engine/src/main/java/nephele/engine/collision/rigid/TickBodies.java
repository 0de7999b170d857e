package nephele.engine.collision.rigid;

/** The bodies of one tick while it is worked on: what the next {@link Bodies} will be made of. */
final class TickBodies {
    double[] motion = new double[0];
    float[] rest = new float[0];
    int count;

    private static final double LARGEST = 1e12;

    void load(Bodies before) {
        motion = before.motion().clone();
        rest = before.rest().clone();
        count = rest.length;
        for (int body = 0; body < count; body++) {
            if (!isFinite(body)) {
                freeze(body, before);
            }
        }
    }

    boolean isAwake(int body) {
        return rest[body] >= 0;
    }

    boolean isFinite(int body) {
        double sum = 0;
        for (int i = Bodies.STRIDE * body; i < Bodies.STRIDE * (body + 1); i++) {
            sum += Math.abs(motion[i]);
        }
        return sum < LARGEST;
    }

    /** Stops a body where it was last, for good: nothing can be computed from what it has become. */
    void freeze(int body, Bodies before) {
        int at = Bodies.STRIDE * body;
        System.arraycopy(before.motion(), at, motion, at, Bodies.VELOCITY);
        for (int i = 0; i < Bodies.VELOCITY; i++) {
            motion[at + i] = Math.abs(motion[at + i]) < LARGEST ? motion[at + i] : i == 6 ? 1 : 0;
        }
        halt(body);
        rest[body] = Bodies.FROZEN;
    }

    void halt(int body) {
        int at = Bodies.STRIDE * body;
        for (int i = Bodies.VELOCITY; i < Bodies.STRIDE; i++) {
            motion[at + i] = 0;
        }
    }

    void wake(int body) {
        if (rest[body] == Bodies.ASLEEP) {
            rest[body] = 0;
        }
    }
}
