package nephele.engine.sim.player;

import static nephele.engine.sim.state.PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED;
import static nephele.engine.sim.state.PlayerDimensions.MIN_GROUND_NORMAL_Y;

import nephele.engine.sim.state.PlayerDimensions;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The player's contacts with bodies in a tick, and its pushes on them. A body that gives way does not stop the player.
 * One that does not is pushed with a limited force, and one that the player stands on bears its weight. The working set
 * of one simulation.
 */
public final class BodyPushes {
    private static final int CAPACITY = 8;
    private static final double MAX_NEWTONS = 400;

    private final Vector3d[] normals = new Vector3d[CAPACITY];
    private final Vector3d[] velocities = new Vector3d[CAPACITY];
    private final Vector3d wished = new Vector3d();
    private final Vector3d push = new Vector3d();
    private int size;

    BodyPushes() {
        for (int i = 0; i < CAPACITY; i++) {
            normals[i] = new Vector3d();
            velocities[i] = new Vector3d();
        }
    }

    void clear() {
        size = 0;
        wished.zero();
        push.zero();
    }

    /** Sets the velocity that the player would have without obstacles. */
    void intent(Vector3dc velocity) {
        wished.set(velocity);
    }

    /**
     * Records a contact.
     *
     * @param normal of the body's surface, towards the player
     * @param velocity of the body at the contact
     */
    void met(Vector3dc normal, Vector3dc velocity) {
        if (size < CAPACITY) {
            normals[size].set(normal);
            velocities[size++].set(velocity);
        }
    }

    /** Restores the player's velocity as far as the bodies give way, and computes the push on them. */
    void settle(PlayerMotion player, double seconds) {
        double legs = MAX_NEWTONS * seconds / PlayerDimensions.MASS_KILOGRAMS;
        push.zero();
        for (int i = 0; i < size; i++) {
            Vector3d n = normals[i];
            double into = -wished.dot(n);
            if (into > 0) {
                double givesWay = Math.min(into, -velocities[i].dot(n)) + player.velocity.dot(n);
                if (givesWay > 0) {
                    player.velocity.fma(-givesWay, n);
                }
                double rest = into + player.velocity.dot(n);
                push.fma(-Math.max(0, Math.min(rest, legs) + push.dot(n)), n);
            }
        }
        int support = player.grounded ? support() : -1;
        if (support >= 0) {
            push.y = velocities[support].y - GRAVITY_METRES_PER_SECOND_SQUARED * seconds;
        }
    }

    /** Returns the last contact on which the player stands; −1 for none. */
    private int support() {
        for (int i = size - 1; i >= 0; i--) {
            if (normals[i].y >= MIN_GROUND_NORMAL_Y) {
                return i;
            }
        }
        return -1;
    }

    public boolean isTouching() {
        return size > 0;
    }

    /**
     * Returns the velocity, m/s, that the player's capsule has towards bodies on top of its own: the push of the legs,
     * and the fall onto a support.
     */
    public Vector3dc push() {
        return push;
    }
}
