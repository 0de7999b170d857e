package nephele.engine.collision.rigid;

import java.util.Arrays;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyFrameSpin;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyPortalState;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.collision.rigid.body.FreeRotation;
import nephele.engine.collision.rigid.body.Poses;
import nephele.engine.collision.rigid.contact.NarrowPhase;
import nephele.engine.collision.rigid.solver.SolverState;
import nephele.engine.math.Vec3;
import nephele.engine.portal.PortalCrossing;
import nephele.engine.portal.PortalTransform;
import nephele.engine.portal.Portals;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * Advances one body to the end of the tick: along the exact parabola p + v t + g t² / 2 if it has no contacts, along
 * the solver's displacement otherwise; through every portal that its centre enters, and with continuous collision
 * detection against whatever it could tunnel through. Reused.
 */
final class ContinuousMotion {
    /** Greatest depth of a fast body in what it hits; at most an eighth of its thickness. */
    private static final double MOST_DEPTH_METRES = 6e-4;

    private static final double MOST_TURN_DEPTH_METRES = 5e-3;

    /** A displacement cut short by less is not counted as a fault. */
    private static final double LOST_METRES = 1e-3;

    private static final int MOST_SLIDES = 4;

    private final BodyTable table;
    private final Vec3 gravity;
    private final ContactSearch search;
    private final NarrowPhase narrow;
    private final Poses poses;
    private final FreeRotation freeRotation = new FreeRotation();
    private final ConservativeAdvancement sweep = new ConservativeAdvancement();
    private final ContinuousPairs pairs;
    private final ContinuousRotation turn;
    private final BodyFrameSpin carry = new BodyFrameSpin();
    private final double[] axes = new double[9];
    private final PortalCrossing crossing = new PortalCrossing();
    private final Vector3d place = new Vector3d();
    private final Vector3d velocity = new Vector3d();
    private final Vector3d pull = new Vector3d();
    private final Vector3d way = new Vector3d();
    private final Vector3d turning = new Vector3d();
    /** Outward normal of the obstacle that leaves no free share. */
    private final Vector3d blocking = new Vector3d();

    /** For each crossing of the tick, the share of the duration that remained after it. */
    private final double[] shareBeyond = new double[BodyPortalState.MOST];

    private final Quaterniond orientation = new Quaterniond();
    private PortalWorld surroundings;
    private Portals portals;
    private double seconds;
    /** The work of gravity per kilogram over the displacement that was blocked, m²/s². */
    private double held;

    /** The displacement over which gravity has changed the velocity. */
    private final Vector3d paidWay = new Vector3d();

    ContinuousMotion(BodyTable table, Vec3 gravity, ContactSearch search, Poses poses) {
        this.table = table;
        this.gravity = gravity;
        this.search = search;
        narrow = search.narrow();
        this.poses = poses;
        pairs = new ContinuousPairs(poses, narrow);
        turn = new ContinuousRotation(poses, narrow, sweep);
    }

    void begin(PortalWorld around, BodyInfluences influences, TickBodies bodies, double tickSeconds) {
        surroundings = around;
        portals = around.portals();
        seconds = tickSeconds;
        pairs.begin(bodies.count, influences, seconds);
    }

    /**
     * Sets the displacements that the bodies would have without obstacles.
     *
     * @param pressed true for bodies that the solver moved
     */
    void expect(TickBodies bodies, boolean[] pressed, SolverState motions) {
        double half = seconds * seconds / 2;
        for (int body = 0; body < bodies.count; body++) {
            int v = Bodies.STRIDE * body + Bodies.VELOCITY;
            double[] m = bodies.motion;
            if (pressed[body]) {
                int d = 6 * body;
                pairs.way(body, motions.moved[d], motions.moved[d + 1], motions.moved[d + 2]);
            } else if (bodies.isAwake(body)) {
                pairs.way(
                        body,
                        m[v] * seconds + gravity.x() * half,
                        m[v + 1] * seconds + gravity.y() * half,
                        m[v + 2] * seconds + gravity.z() * half);
            }
        }
    }

    /** Advances a body that had no contact in this tick. */
    void advanceFree(TickBodies bodies, int body, boolean falls) {
        double[] m = bodies.motion;
        int at = Bodies.STRIDE * body;
        velocity.set(m[at + 7], m[at + 8], m[at + 9]);
        pull.set(gravity.x(), gravity.y(), gravity.z()).mul(falls ? 1 : 0);
        travel(bodies, body, seconds);
        m[at + 7] = velocity.x;
        m[at + 8] = velocity.y;
        m[at + 9] = velocity.z;
        if (held != 0 && falls) {
            removeUnearnedSpeed(m, at + Bodies.VELOCITY);
        }
        turn.begin(m, at + Bodies.ORIENTATION);
        freeRotation.turn(m, at, seconds, table, body);
        fitTurn(bodies, body);
    }

    /** Advances a body that the solver moved. */
    void advanceSolved(TickBodies bodies, int body, SolverState motions, boolean falls) {
        double[] m = bodies.motion;
        int at = Bodies.STRIDE * body;
        int d = 6 * body;
        System.arraycopy(motions.velocity, d, m, at + Bodies.VELOCITY, 6);
        velocity.set(motions.moved[d], motions.moved[d + 1], motions.moved[d + 2]);
        pull.zero();
        travel(bodies, body, 1);
        if (held != 0 && falls) {
            removeUnearnedSpeed(m, at + Bodies.VELOCITY);
        }
        for (int i = bodies.firstCrossing(body); i < bodies.crossings(body); i++) {
            PortalTransform transform = portals.transform(bodies.crossing(body, i));
            mapDirection(m, at + Bodies.VELOCITY, transform);
            mapDirection(motions.moved, d + 3, transform);
            if (falls) {
                fallBeyond(m, at + Bodies.VELOCITY, transform, shareBeyond[i]);
            }
        }
        turn.begin(m, at + Bodies.ORIENTATION);
        if (table.isEven(body)) {
            FreeRotation.turnBy(m, at, motions.moved[d + 3], motions.moved[d + 4], motions.moved[d + 5]);
        } else {
            turnUnevenly(m, at, body, motions);
        }
        fitTurn(bodies, body);
    }

    /**
     * Rotates freely by the remaining angular velocity, which conserves the energy, and then by the rest of the
     * solver's rotation.
     */
    private void turnUnevenly(double[] m, int at, int body, SolverState motions) {
        int w = at + Bodies.SPIN;
        int d = 6 * body;
        double x = motions.moved[d + 3] - seconds * m[w];
        double y = motions.moved[d + 4] - seconds * m[w + 1];
        double z = motions.moved[d + 5] - seconds * m[w + 2];
        freeRotation.turn(m, at, seconds, table, body);
        if (x != 0 || y != 0 || z != 0) {
            carry.begin(m, at);
            FreeRotation.turnBy(m, at, x, y, z);
            carry.end(m, at);
        }
    }

    /**
     * Removes the speed that gravity has given over a blocked displacement, which would add energy. The downward speed
     * is reduced by the energy of the missing height, v² = 2 g h.
     */
    private void removeUnearnedSpeed(double[] m, int v) {
        double g = Math.sqrt(gravity.dot(gravity));
        double down = (m[v] * gravity.x() + m[v + 1] * gravity.y() + m[v + 2] * gravity.z()) / g;
        if (held > 0 && down > 0) {
            double change = (Math.sqrt(Math.max(0, down * down - 2 * held)) - down) / g;
            m[v] += change * gravity.x();
            m[v + 1] += change * gravity.y();
            m[v + 2] += change * gravity.z();
        }
    }

    /**
     * Corrects the velocity for the part of the tick behind a portal, where gravity has the world's direction and not
     * the entry's rotated one.
     */
    private void fallBeyond(double[] m, int v, PortalTransform transform, double share) {
        turning.set(gravity.x(), gravity.y(), gravity.z());
        transform.direction(turning);
        m[v] += share * seconds * (gravity.x() - turning.x);
        m[v + 1] += share * seconds * (gravity.y() - turning.y);
        m[v + 2] += share * seconds * (gravity.z() - turning.z);
    }

    private void mapDirection(double[] of, int at, PortalTransform transform) {
        turning.set(of[at], of[at + 1], of[at + 2]);
        transform.direction(turning);
        of[at] = turning.x;
        of[at + 1] = turning.y;
        of[at + 2] = turning.z;
    }

    private void fitTurn(TickBodies bodies, int body) {
        int q = Bodies.STRIDE * body + Bodies.ORIENTATION;
        if (turn.isFast(bodies.motion, q, body, farMetres(body))) {
            System.arraycopy(poses.axes, 9 * body, axes, 0, 9);
            carry.begin(bodies.motion, Bodies.STRIDE * body);
            boolean turns = turn.fit(bodies.motion, q, body, place, surroundings, turnDepth(body));
            carry.end(bodies.motion, Bodies.STRIDE * body);
            if (!turns) {
                // Corners that turn away from a wall by the angular velocity, but not in fact, would keep the solver
                // from stopping the body.
                int w = Bodies.STRIDE * body + Bodies.SPIN;
                Arrays.fill(bodies.motion, w, w + 3, 0);
            }
            System.arraycopy(axes, 0, poses.axes, 9 * body, 9);
        }
    }

    /** Returns the displacement in a tick above which the body could tunnel through something. */
    private double farMetres(int body) {
        return poses.leastHalf(body) / 2;
    }

    /** Returns the allowed depth after a rotation: the solver corrects it, but the body must not get through. */
    private double turnDepth(int body) {
        return Math.min(MOST_TURN_DEPTH_METRES, farMetres(body));
    }

    private double depth(int body) {
        return Math.min(MOST_DEPTH_METRES, farMetres(body) / 4);
    }

    /**
     * Advances from the body's place with {@link #velocity} and {@link #pull}, portal by portal.
     *
     * @param duration in the unit of time of {@link #velocity}
     */
    private void travel(TickBodies bodies, int body, double duration) {
        double[] m = bodies.motion;
        int at = Bodies.STRIDE * body;
        place.set(m[at], m[at + 1], m[at + 2]);
        held = 0;
        double left = duration;
        while (left > 0) {
            boolean enters = portals.size() > 0 && crossing.find(portals, place, velocity, pull, left);
            double t = enters ? crossing.seconds() : left;
            velocity.mul(t, way).fma(t * t / 2, pull);
            if (way.lengthSquared() > farMetres(body) * farMetres(body) && isStopped(bodies, body, t, left)) {
                break;
            }
            if (!enters) {
                advance(t);
                break;
            }
            if (!bodies.enter(body, crossing.portal())) {
                bodies.cutShort += slide(bodies, body, left) > LOST_METRES ? 1 : 0;
                break;
            }
            velocity.fma(t, pull);
            place.set(crossing.place());
            pass(m, at, portals.transform(crossing.portal()));
            left -= t;
            shareBeyond[bodies.crossings(body) - 1] = left / duration;
        }
        m[at] = place.x;
        m[at + 1] = place.y;
        m[at + 2] = place.z;
    }

    /**
     * Moves along the plane of a portal a body that hovers there and passes it ever more often over ever shorter
     * distances.
     *
     * @return metres across the plane that are lost
     */
    private double slide(TickBodies bodies, int body, double left) {
        Vec3 n = portals.portal(crossing.portal()).normal();
        double across = left * (velocity.x * n.x() + velocity.y * n.y() + velocity.z * n.z());
        velocity.mul(left, way).sub(across * n.x(), across * n.y(), across * n.z());
        boolean isFar = way.lengthSquared() > farMetres(body) * farMetres(body);
        place.fma(isFar ? freeShare(bodies, body) : 1, way);
        return Math.abs(across);
    }

    private void advance(double t) {
        place.fma(t, velocity).fma(t * t / 2, pull);
        velocity.fma(t, pull);
    }

    private void pass(double[] m, int at, PortalTransform transform) {
        transform.point(place);
        transform.direction(velocity);
        int q = at + Bodies.ORIENTATION;
        orientation.set(m[q], m[q + 1], m[q + 2], m[q + 3]);
        transform.orientation(orientation);
        m[q] = orientation.x;
        m[q + 1] = orientation.y;
        m[q + 2] = orientation.z;
        m[q + 3] = orientation.w;
        int w = at + Bodies.SPIN;
        turning.set(m[w], m[w + 1], m[w + 2]);
        transform.direction(turning);
        m[w] = turning.x;
        m[w + 1] = turning.y;
        m[w + 2] = turning.z;
    }

    /**
     * Returns true if an obstacle blocks the displacement; the body has then advanced as far as possible, or along what
     * it is deep inside.
     *
     * @param t time of the displacement; {@code left}: time of the rest of the tick
     */
    private boolean isStopped(TickBodies bodies, int body, double t, double left) {
        double share = freeShare(bodies, body);
        if (share >= 1) {
            return false;
        }
        velocity.mul(left, paidWay);
        for (int i = 0; share == 0 && i < MOST_SLIDES; i++) {
            way.fma(-way.dot(blocking), blocking);
            boolean enters = portals.size() > 0 && crossing.find(portals, place, way, turning.zero(), 1);
            share = enters ? 0 : freeShare(bodies, body);
        }
        place.fma(share, way);
        if (pull.lengthSquared() > 0) {
            velocity.mul(share * t, paidWay).fma(share * share * t * t / 2, pull);
            velocity.fma(share * t, pull);
        }
        paidWay.fma(-share, way);
        held = gravity.x() * paidWay.x + gravity.y() * paidWay.y + gravity.z() * paidWay.z;
        return true;
    }

    /** Returns the share of the displacement that is free of solids, bodies and characters. */
    private double freeShare(TickBodies bodies, int body) {
        System.arraycopy(poses.axes, 9 * body, axes, 0, 9);
        boolean hasCrossed = bodies.hasCrossed(body);
        if (hasCrossed) {
            double[] m = bodies.motion;
            int q = Bodies.STRIDE * body + Bodies.ORIENTATION;
            poses.turn(body, m[q], m[q + 1], m[q + 2], m[q + 3]);
        }
        // The solver keeps apart solids and bodies with contacts, rotations included.
        boolean held = !hasCrossed && way.length() <= search.farMetres(body);
        double free =
                pairs.free(body, place, way, depth(body), hasCrossed, other -> held && search.metOther(body, other));
        blocking.set(pairs.normal());
        if (free > 0) {
            var hull = narrow.turnedHull(body);
            long mask = portals.size() == 0 ? 0 : surroundings.active(hull, place, way);
            boolean same = held && mask == bodies.active(body);
            free = Math.min(
                    free,
                    sweep.free(
                            surroundings.openedFor(mask),
                            hull,
                            place,
                            way,
                            depth(body),
                            solid -> same && search.metSolid(body, solid)));
            blocking.set(sweep.normal());
        }
        System.arraycopy(axes, 0, poses.axes, 9 * body, 9);
        return free;
    }
}
