package nephele.engine.collision.rigid.body;

import java.util.List;
import nephele.engine.math.Hash64;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * The motion of all bodies at one tick, with the state from which the next tick continues deterministically: each
 * body's time at rest and the contact cache. A value: {@link nephele.engine.collision.rigid.RigidStep} makes the next one.
 */
public final class Bodies {
    public static final Bodies NONE = of(List.of());

    /** Number of doubles for each body: centre 3, orientation x y z w, velocity 3, angular velocity 3. */
    public static final int STRIDE = 13;

    public static final int ORIENTATION = 3;
    public static final int VELOCITY = 7;
    public static final int SPIN = 10;

    /** Stored instead of the seconds of rest. */
    public static final float ASLEEP = -1;

    public static final float FROZEN = -2;

    private final double[] motion;
    private final float[] rest;
    private final ContactCache contacts;
    private final BodyPortalState transforms;

    public Bodies(double[] motion, float[] rest, ContactCache contacts, BodyPortalState transforms) {
        this.motion = motion;
        this.rest = rest;
        this.contacts = contacts;
        this.transforms = transforms;
    }

    /** Returns these bodies, awake and without contacts. */
    public static Bodies of(List<BodyState> states) {
        double[] motion = new double[STRIDE * states.size()];
        for (int i = 0; i < states.size(); i++) {
            write(states.get(i), motion, i);
        }
        return new Bodies(motion, new float[states.size()], ContactCache.NONE, BodyPortalState.NONE);
    }

    private static void write(BodyState state, double[] motion, int body) {
        int at = STRIDE * body;
        put(motion, at, state.centre());
        motion[at + ORIENTATION] = state.orientation().x;
        motion[at + ORIENTATION + 1] = state.orientation().y;
        motion[at + ORIENTATION + 2] = state.orientation().z;
        motion[at + ORIENTATION + 3] = state.orientation().w;
        put(motion, at + VELOCITY, state.velocity());
        put(motion, at + SPIN, state.spin());
    }

    private static void put(double[] motion, int at, Vec3 v) {
        motion[at] = v.x();
        motion[at + 1] = v.y();
        motion[at + 2] = v.z();
    }

    /** Returns the number of bodies. */
    public int size() {
        return rest.length;
    }

    /** Sets {@code out} to the centre of mass in the world and returns it. */
    public Vector3d centre(int body, Vector3d out) {
        int at = STRIDE * body;
        return out.set(motion[at], motion[at + 1], motion[at + 2]);
    }

    /** Sets {@code out} to the unit rotation from body to world axes and returns it. */
    public Quaterniond orientation(int body, Quaterniond out) {
        int at = STRIDE * body + ORIENTATION;
        return out.set(motion[at], motion[at + 1], motion[at + 2], motion[at + 3]);
    }

    /** Sets {@code out} to the velocity of the centre in m/s and returns it. */
    public Vector3d velocity(int body, Vector3d out) {
        int at = STRIDE * body + VELOCITY;
        return out.set(motion[at], motion[at + 1], motion[at + 2]);
    }

    /** Sets {@code out} to the angular velocity in world axes, rad/s, and returns it. */
    public Vector3d spin(int body, Vector3d out) {
        int at = STRIDE * body + SPIN;
        return out.set(motion[at], motion[at + 1], motion[at + 2]);
    }

    /** Returns a body's motion as a value. */
    public BodyState state(int body) {
        return new BodyState(
                vector(body, 0), orientation(body, new Quaterniond()), vector(body, VELOCITY), vector(body, SPIN));
    }

    private Vec3 vector(int body, int offset) {
        int at = STRIDE * body + offset;
        return new Vec3(motion[at], motion[at + 1], motion[at + 2]);
    }

    /** Returns true if a body is asleep: it rests and is not simulated. */
    public boolean isAsleep(int body) {
        return rest[body] == ASLEEP;
    }

    /** Returns true for a body of which the motion was no longer finite: it stays at its last finite place. */
    public boolean isFrozen(int body) {
        return rest[body] == FROZEN;
    }

    /** Returns the number of frozen bodies. */
    public int frozen() {
        int count = 0;
        for (float seconds : rest) {
            count += seconds == FROZEN ? 1 : 0;
        }
        return count;
    }

    /** Returns the number of portals that a body's centre went through in the last tick. */
    public int crossings(int body) {
        return transforms.count(body);
    }

    /**
     * Returns the index of one of these portals, in the order of passage; for interpolated frames and for whatever
     * follows the body.
     */
    public int crossing(int body, int place) {
        return transforms.entered(body, place);
    }

    /** Returns the same bodies with one in another state; it is awake and the next tick ignores its old contacts. */
    public Bodies with(int body, BodyState state) {
        double[] moved = motion.clone();
        write(state, moved, body);
        float[] woken = rest.clone();
        woken[body] = 0;
        return new Bodies(moved, woken, contacts, transforms);
    }

    /** Returns the same bodies without crossings, at these portals, for a tick in which nothing moved. */
    public Bodies at(Portals portals) {
        return transforms.isAt(portals) ? this : new Bodies(motion, rest, contacts, transforms.at(portals));
    }

    /** Returns a 64-bit hash of everything that the next tick depends on, joined to {@code before}. */
    public long hash(long before) {
        long hash = Hash64.combine(before, (long) rest.length);
        for (double number : motion) {
            hash = Hash64.combine(hash, number);
        }
        for (float seconds : rest) {
            hash = Hash64.combine(hash, Float.floatToIntBits(seconds));
        }
        return transforms.hash(contacts.hash(hash));
    }

    public double[] motion() {
        return motion;
    }

    public float[] rest() {
        return rest;
    }

    public ContactCache contacts() {
        return contacts;
    }

    public BodyPortalState transforms() {
        return transforms;
    }
}
