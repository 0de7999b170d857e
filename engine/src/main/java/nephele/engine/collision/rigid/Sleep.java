package nephele.engine.collision.rigid;

import java.util.Arrays;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.ContactCache;
import nephele.engine.collision.rigid.body.Poses;
import nephele.engine.collision.rigid.solver.ContactRows;
import nephele.engine.collision.rigid.solver.Islands;

/** Puts resting islands of bodies to sleep, and wakes those in contact with an awake body. Reused. */
final class Sleep {
    /** Time for which an island rests before it sleeps. */
    private static final float SLEEP_SECONDS = 0.5f;

    private static final double REST_METRES_PER_SECOND = 0.03;

    private final TickBodies bodies;
    private final Poses poses;
    private final ContactRows rows;
    private final Islands islands = new Islands();
    private float[] islandRest = new float[0];
    private boolean[] pressed = new boolean[0];

    Sleep(TickBodies bodies, Poses poses, ContactRows rows) {
        this.bodies = bodies;
        this.poses = poses;
        this.rows = rows;
    }

    /** Wakes the bodies that were in contact with an awake one, directly or through others. */
    void wakeNeighbours(ContactCache memory) {
        boolean anyAsleep = false;
        for (int body = 0; body < bodies.count; body++) {
            anyAsleep |= bodies.rest[body] == Bodies.ASLEEP;
        }
        if (!anyAsleep) {
            return;
        }
        if (pressed.length < bodies.count) {
            pressed = new boolean[bodies.count];
        }
        islands.reset(bodies.count);
        for (int i = 0; i < memory.size(); i++) {
            int a = ContactCache.first(memory.key(i));
            int b = ContactCache.second(memory.key(i));
            if (a < bodies.count && b >= 0 && b < bodies.count) {
                islands.join(a, b);
            }
        }
        Arrays.fill(pressed, 0, bodies.count, false);
        for (int body = 0; body < bodies.count; body++) {
            pressed[islands.root(body)] |= bodies.isAwake(body);
        }
        for (int body = 0; body < bodies.count; body++) {
            if (pressed[islands.root(body)]) {
                bodies.wake(body);
            }
        }
    }

    /**
     * Counts each body's time at rest, and puts islands to sleep that have rested long enough.
     *
     * @param carried true for bodies with contact impulses in this step
     * @param driven true for bodies that a character holds
     */
    void fallAsleep(boolean[] carried, boolean[] driven, double seconds) {
        islands.reset(bodies.count);
        for (int m = 0; m < rows.count; m++) {
            if (rows.slotA[m] < bodies.count && rows.slotB[m] < bodies.count && rows.carries(m)) {
                islands.join(rows.slotA[m], rows.slotB[m]);
            }
        }
        for (int body = 0; body < bodies.count; body++) {
            if (bodies.isAwake(body)) {
                boolean resting = carried[body] && !driven[body] && isSlow(body);
                bodies.rest[body] = resting ? Math.min(1, bodies.rest[body] + (float) seconds) : 0;
            }
        }
        if (islandRest.length < bodies.count) {
            islandRest = new float[bodies.count];
        }
        islands.least(bodies.rest, bodies.count, islandRest);
        for (int body = 0; body < bodies.count; body++) {
            if (bodies.isAwake(body) && islandRest[islands.root(body)] >= SLEEP_SECONDS) {
                bodies.halt(body);
                bodies.rest[body] = Bodies.ASLEEP;
            }
        }
    }

    private boolean isSlow(int body) {
        double[] m = bodies.motion;
        int v = Bodies.STRIDE * body + Bodies.VELOCITY;
        int w = Bodies.STRIDE * body + Bodies.SPIN;
        double radius = poses.radius(body);
        double square = m[v] * m[v] + m[v + 1] * m[v + 1] + m[v + 2] * m[v + 2];
        square += radius * radius * (m[w] * m[w] + m[w + 1] * m[w + 1] + m[w + 2] * m[w + 2]);
        return square < REST_METRES_PER_SECOND * REST_METRES_PER_SECOND;
    }
}
