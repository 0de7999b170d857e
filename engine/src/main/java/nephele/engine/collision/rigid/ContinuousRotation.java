package nephele.engine.collision.rigid;

import java.util.Arrays;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.collision.rigid.body.FreeRotation;
import nephele.engine.collision.rigid.body.Poses;
import nephele.engine.collision.rigid.contact.NarrowPhase;
import nephele.engine.portal.Portals;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Rotates one body to the end of the tick: freely if it has no contacts, by the solver's rotation otherwise, and no
 * deeper into solids than allowed. After an impact an edge can rotate a radian in a tick, and a body that has rotated
 * through a wall would be pushed out on the wrong side; solids are asked only when corners move far. Reused.
 */
final class ContinuousRotation {
    private static final int MOST_HALVINGS = 6;
    /** Greatest depth after a rotation: the solver corrects it, but the body must not get through. */
    private static final double MOST_DEPTH_METRES = 5e-3;

    private final BodyTable table;
    private final Poses poses;
    private final NarrowPhase narrow;
    private final ContinuousCollision collision;
    private final FreeRotation freeRotation = new FreeRotation();
    private final double[] before = new double[4];
    private final double[] after = new double[4];
    private final double[] axes = new double[9];
    private final Quaterniond orientation = new Quaterniond();
    private final Vector3d spinInBody = new Vector3d();
    /** The body's numbers from {@link #at} on, {@link Bodies#STRIDE}; its centre is at {@link #place}. */
    private double[] motion;

    private int body;
    private int at;
    private Vector3dc place;
    private PortalWorld surroundings;

    ContinuousRotation(BodyTable table, Poses poses, NarrowPhase narrow, ContinuousCollision collision) {
        this.table = table;
        this.poses = poses;
        this.narrow = narrow;
        this.collision = collision;
    }

    /** Rotates a body that had no contact in this tick. */
    void turnFree(double[] itsMotion, int itsBody, Vector3dc itsPlace, PortalWorld around, double seconds) {
        begin(itsMotion, itsBody, itsPlace, around);
        freeRotation.turn(motion, at, seconds, table, body);
        limit();
    }

    /**
     * Rotates a body that the solver moved.
     *
     * @param rotation three numbers from {@code r} on: the solver's rotation vector
     */
    void turnSolved(
            double[] itsMotion,
            int itsBody,
            Vector3dc itsPlace,
            PortalWorld around,
            double[] rotation,
            int r,
            double seconds) {
        begin(itsMotion, itsBody, itsPlace, around);
        if (table.isEven(body)) {
            FreeRotation.turnBy(motion, at, rotation[r], rotation[r + 1], rotation[r + 2]);
        } else {
            turnUnevenly(rotation, r, seconds);
        }
        limit();
    }

    private void begin(double[] itsMotion, int itsBody, Vector3dc itsPlace, PortalWorld around) {
        motion = itsMotion;
        body = itsBody;
        at = Bodies.STRIDE * body;
        place = itsPlace;
        surroundings = around;
        System.arraycopy(motion, at + Bodies.ORIENTATION, before, 0, 4);
    }

    /**
     * Rotates freely by the remaining angular velocity, which conserves the energy, and then by the rest of the
     * solver's rotation.
     */
    private void turnUnevenly(double[] rotation, int r, double seconds) {
        int w = at + Bodies.SPIN;
        double x = rotation[r] - seconds * motion[w];
        double y = rotation[r + 1] - seconds * motion[w + 1];
        double z = rotation[r + 2] - seconds * motion[w + 2];
        freeRotation.turn(motion, at, seconds, table, body);
        if (x != 0 || y != 0 || z != 0) {
            readSpinInBody();
            FreeRotation.turnBy(motion, at, x, y, z);
            writeSpinInBody();
        }
    }

    /**
     * Reads the angular velocity in the body's axes, before the orientation is corrected. The energy of rotation depends
     * on the angular velocity in these axes alone: a needle with angular velocity constant in world axes would gain a
     * million times its energy by a correction of one degree.
     */
    private void readSpinInBody() {
        readOrientation();
        int w = at + Bodies.SPIN;
        orientation.transformInverse(spinInBody.set(motion[w], motion[w + 1], motion[w + 2]));
    }

    /** Writes the angular velocity for the body's corrected orientation. */
    private void writeSpinInBody() {
        readOrientation();
        orientation.transform(spinInBody);
        int w = at + Bodies.SPIN;
        motion[w] = spinInBody.x;
        motion[w + 1] = spinInBody.y;
        motion[w + 2] = spinInBody.z;
    }

    private void readOrientation() {
        int q = at + Bodies.ORIENTATION;
        orientation.set(motion[q], motion[q + 1], motion[q + 2], motion[q + 3]);
    }

    /** Limits the rotation since {@link #begin} to the allowed depth in solids. */
    private void limit() {
        if (!isFast()) {
            return;
        }
        System.arraycopy(poses.axes, Poses.AXES * body, axes, 0, 9);
        readSpinInBody();
        boolean turns = fit(Math.min(MOST_DEPTH_METRES, poses.leastHalf(body) / 2));
        writeSpinInBody();
        if (!turns) {
            // Corners that turn away from a wall by the angular velocity, but not in fact, would keep the solver
            // from stopping the body.
            Arrays.fill(motion, at + Bodies.SPIN, at + Bodies.STRIDE, 0);
        }
        System.arraycopy(axes, 0, poses.axes, Poses.AXES * body, 9);
    }

    /** Returns true if a corner may have moved so far that the body could have got through something. */
    private boolean isFast() {
        if (poses.kind[body] == BodyTable.SPHERE) {
            return false;
        }
        double metres = poses.leastHalf(body) / 2;
        double cosine = 0;
        for (int i = 0; i < 4; i++) {
            cosine += before[i] * motion[at + Bodies.ORIENTATION + i];
        }
        double chord = 2 * poses.radius(body);
        return chord * chord * (1 - cosine * cosine) > metres * metres;
    }

    /**
     * Reduces the rotation until the body is no deeper in a solid than {@code depth}, or than it was before.
     *
     * @return false if nothing is left of the rotation
     */
    private boolean fit(double depth) {
        int q = at + Bodies.ORIENTATION;
        System.arraycopy(motion, q, after, 0, 4);
        double most = Math.min(-depth, gap(before, 0));
        double fraction = 1;
        for (int i = 0; i <= MOST_HALVINGS; i++) {
            if (gap(motion, q) >= most) {
                return fraction > 0;
            }
            fraction /= 2;
            fraction = i == MOST_HALVINGS ? 0 : fraction;
            interpolate(fraction, q);
        }
        return false;
    }

    private double gap(double[] turned, int q) {
        poses.turn(body, turned[q], turned[q + 1], turned[q + 2], turned[q + 3]);
        var hull = narrow.turnedHull(body);
        Portals portals = surroundings.portals();
        CollisionWorld world = surroundings.openedFor(portals.size() == 0 ? 0 : surroundings.active(hull, place));
        return collision.gap(world, hull, place);
    }

    /** Interpolates both orientations along the shorter arc, by the normalised mean of the quaternions. */
    private void interpolate(double fraction, int q) {
        double cosine = 0;
        for (int i = 0; i < 4; i++) {
            cosine += before[i] * after[i];
        }
        double square = 0;
        for (int i = 0; i < 4; i++) {
            motion[q + i] = (1 - fraction) * before[i] + (cosine < 0 ? -fraction : fraction) * after[i];
            square += motion[q + i] * motion[q + i];
        }
        for (int i = 0; i < 4; i++) {
            motion[q + i] = fraction == 0 ? before[i] : motion[q + i] / Math.sqrt(square);
        }
    }
}
