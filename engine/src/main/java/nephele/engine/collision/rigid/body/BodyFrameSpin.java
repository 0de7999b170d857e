package nephele.engine.collision.rigid.body;

import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * Keeps a body's angular velocity constant in the body's axes while its orientation is corrected. The energy of
 * rotation depends on the angular velocity in these axes alone: a needle with angular velocity constant in world axes
 * would gain a million times its energy by a correction of one degree. Reused.
 */
public final class BodyFrameSpin {
    private final Quaterniond orientation = new Quaterniond();
    private final Vector3d spin = new Vector3d();

    /** Reads the angular velocity before the orientation changes, of the body with numbers from {@code at} on. */
    public void begin(double[] motion, int at) {
        read(motion, at);
        int w = at + Bodies.SPIN;
        orientation.transformInverse(spin.set(motion[w], motion[w + 1], motion[w + 2]));
    }

    /** Writes the angular velocity for the body's new orientation. */
    public void end(double[] motion, int at) {
        read(motion, at);
        orientation.transform(spin);
        int w = at + Bodies.SPIN;
        motion[w] = spin.x;
        motion[w + 1] = spin.y;
        motion[w + 2] = spin.z;
    }

    private void read(double[] motion, int at) {
        int q = at + Bodies.ORIENTATION;
        orientation.set(motion[q], motion[q + 1], motion[q + 2], motion[q + 3]);
    }
}
