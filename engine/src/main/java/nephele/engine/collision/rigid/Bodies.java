package nephele.engine.collision.rigid;

import java.util.List;
import nephele.engine.math.BitHash;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * The motion of all bodies at one tick, with what the next tick needs to go on as if nothing had been written down: how
 * long each has rested and what its contacts carried. A value: {@link RigidStep} makes the next one.
 */
public final class Bodies {
    public static final Bodies NONE = of(List.of());

    /** Doubles a body: centre 3, orientation x y z w, velocity 3, spin 3. */
    static final int STRIDE = 13;

    static final int ORIENTATION = 3;
    static final int VELOCITY = 7;
    static final int SPIN = 10;

    /** In place of seconds of rest. */
    static final float ASLEEP = -1;

    static final float FROZEN = -2;

    private final double[] motion;
    private final float[] rest;
    private final ContactMemory contacts;
    private final BodyPassages passages;

    Bodies(double[] motion, float[] rest, ContactMemory contacts, BodyPassages passages) {
        this.motion = motion;
        this.rest = rest;
        this.contacts = contacts;
        this.passages = passages;
    }

    /** Awake and without contacts. */
    public static Bodies of(List<BodyState> states) {
        double[] motion = new double[STRIDE * states.size()];
        for (int i = 0; i < states.size(); i++) {
            write(states.get(i), motion, i);
        }
        return new Bodies(motion, new float[states.size()], ContactMemory.NONE, BodyPassages.NONE);
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

    public int size() {
        return rest.length;
    }

    public Vector3d centre(int body, Vector3d out) {
        int at = STRIDE * body;
        return out.set(motion[at], motion[at + 1], motion[at + 2]);
    }

    /** World from body, unit length. */
    public Quaterniond orientation(int body, Quaterniond out) {
        int at = STRIDE * body + ORIENTATION;
        return out.set(motion[at], motion[at + 1], motion[at + 2], motion[at + 3]);
    }

    public Vector3d velocity(int body, Vector3d out) {
        int at = STRIDE * body + VELOCITY;
        return out.set(motion[at], motion[at + 1], motion[at + 2]);
    }

    /** Angular velocity in world axes, rad/s. */
    public Vector3d spin(int body, Vector3d out) {
        int at = STRIDE * body + SPIN;
        return out.set(motion[at], motion[at + 1], motion[at + 2]);
    }

    public BodyState state(int body) {
        return new BodyState(
                vector(body, 0), orientation(body, new Quaterniond()), vector(body, VELOCITY), vector(body, SPIN));
    }

    private Vec3 vector(int body, int offset) {
        int at = STRIDE * body + offset;
        return new Vec3(motion[at], motion[at + 1], motion[at + 2]);
    }

    public boolean isAsleep(int body) {
        return rest[body] == ASLEEP;
    }

    /** True for a body whose motion was no longer finite: it stays where it last was. */
    public boolean isFrozen(int body) {
        return rest[body] == FROZEN;
    }

    /** How many bodies are frozen. */
    public int frozen() {
        int count = 0;
        for (float seconds : rest) {
            count += seconds == FROZEN ? 1 : 0;
        }
        return count;
    }

    /** How many portals a body's centre went through in the last tick. */
    public int crossings(int body) {
        return passages.count(body);
    }

    /** One of these portals, in the order of the way; for pictures between two ticks and for who follows the body. */
    public int crossing(int body, int place) {
        return passages.entered(body, place);
    }

    /** The same with one body elsewhere or otherwise moving; it is awake and its contacts are forgotten by the next tick. */
    public Bodies with(int body, BodyState state) {
        double[] moved = motion.clone();
        write(state, moved, body);
        float[] woken = rest.clone();
        woken[body] = 0;
        return new Bodies(moved, woken, contacts, passages);
    }

    /** The same where nothing moved: crossings of the tick before are forgotten, and the portals are these. */
    Bodies at(Portals portals) {
        return passages.isAt(portals) ? this : new Bodies(motion, rest, contacts, passages.at(portals));
    }

    /** 64 bits over every bit that the next tick depends on. */
    public long hash(long before) {
        long hash = BitHash.join(before, (long) rest.length);
        for (double number : motion) {
            hash = BitHash.join(hash, number);
        }
        for (float seconds : rest) {
            hash = BitHash.join(hash, Float.floatToIntBits(seconds));
        }
        return passages.hash(contacts.hash(hash));
    }

    double[] motion() {
        return motion;
    }

    float[] rest() {
        return rest;
    }

    ContactMemory contacts() {
        return contacts;
    }

    BodyPassages passages() {
        return passages;
    }
}
