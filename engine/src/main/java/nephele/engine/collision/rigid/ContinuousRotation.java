package nephele.engine.collision.rigid;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.collision.rigid.body.Poses;
import nephele.engine.collision.rigid.contact.NarrowPhase;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Continuous collision detection of rotation: limits a body's rotation to the allowed depth in solids. After an impact
 * an edge can rotate a radian in a tick, and a body that has rotated through a wall would be pushed out on the wrong
 * side. Used only when corners move far. Reused.
 */
final class ContinuousRotation {
    private static final int MOST_HALVINGS = 6;

    private final Poses poses;
    private final NarrowPhase narrow;
    private final ConservativeAdvancement sweep;
    private final double[] before = new double[4];
    private final double[] after = new double[4];
    private final Vector3d still = new Vector3d();

    ContinuousRotation(Poses poses, NarrowPhase narrow, ConservativeAdvancement sweep) {
        this.poses = poses;
        this.narrow = narrow;
        this.sweep = sweep;
    }

    /** Stores the orientation at {@code q}. */
    void begin(double[] motion, int q) {
        System.arraycopy(motion, q, before, 0, 4);
    }

    /** Returns true if a corner may have moved by more than {@code metres} since {@link #begin}. */
    boolean isFast(double[] motion, int q, int body, double metres) {
        if (poses.kind[body] == BodyTable.SPHERE) {
            return false;
        }
        double cosine = 0;
        for (int i = 0; i < 4; i++) {
            cosine += before[i] * motion[q + i];
        }
        double chord = 2 * poses.radius(body);
        return chord * chord * (1 - cosine * cosine) > metres * metres;
    }

    /**
     * Reduces the rotation until the body is no deeper in a solid than {@code depth}, or than it was before.
     *
     * @return false if nothing is left of the rotation
     */
    boolean fit(double[] motion, int q, int body, Vector3dc at, PortalWorld surroundings, double depth) {
        System.arraycopy(motion, q, after, 0, 4);
        double most = Math.min(-depth, gap(before, body, at, surroundings));
        double share = 1;
        for (int i = 0; i <= MOST_HALVINGS; i++) {
            if (gap(motion, q, body, at, surroundings) >= most) {
                return share > 0;
            }
            share /= 2;
            share = i == MOST_HALVINGS ? 0 : share;
            towards(share, motion, q);
        }
        return false;
    }

    private double gap(double[] turned, int body, Vector3dc at, PortalWorld surroundings) {
        return gap(turned, 0, body, at, surroundings);
    }

    private double gap(double[] turned, int q, int body, Vector3dc at, PortalWorld surroundings) {
        poses.turn(body, turned[q], turned[q + 1], turned[q + 2], turned[q + 3]);
        var hull = narrow.turnedHull(body);
        Portals portals = surroundings.portals();
        CollisionWorld world = surroundings.openedFor(portals.size() == 0 ? 0 : surroundings.active(hull, at, still));
        return sweep.gap(world, hull, at);
    }

    /** Interpolates both orientations along the shorter arc, by the normalised mean of the quaternions. */
    private void towards(double share, double[] motion, int q) {
        double cosine = 0;
        for (int i = 0; i < 4; i++) {
            cosine += before[i] * after[i];
        }
        double square = 0;
        for (int i = 0; i < 4; i++) {
            motion[q + i] = (1 - share) * before[i] + (cosine < 0 ? -share : share) * after[i];
            square += motion[q + i] * motion[q + i];
        }
        for (int i = 0; i < 4; i++) {
            motion[q + i] = share == 0 ? before[i] : motion[q + i] / Math.sqrt(square);
        }
    }
}
