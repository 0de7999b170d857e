package nephele.engine.collision.rigid;

import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyPortalState;
import nephele.engine.collision.rigid.body.BodyTable;
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
 *
 * <p>The translation is a state machine: it starts {@link State#MOVING}, and each transition takes it to the next portal
 * or to one of the three ends. The rotation follows.
 */
final class ContinuousMotion {
    /** The states of a body's translation. */
    private enum State {
        /** There is time left in the tick. */
        MOVING,
        /** The whole time has passed. */
        ARRIVED,
        /** An obstacle has ended the motion; {@link #blockedWork} is the work that gravity did not do. */
        BLOCKED,
        /** The body has gone through as many portals as it may in a tick, and the rest of the time is lost. */
        CUT_SHORT
    }

    /** Greatest depth of a fast body in what it hits; at most a sixteenth of its thickness. */
    private static final double MOST_DEPTH_METRES = 6e-4;

    /** A displacement cut short by less is not counted as a fault. */
    private static final double LOST_METRES = 1e-3;

    private static final int MOST_SLIDES = 4;

    private final Vec3 gravity;
    private final ContactSearch search;
    private final NarrowPhase narrow;
    private final Poses poses;
    private final ContinuousCollision collision;
    private final ContinuousRotation rotation;
    private final PortalCrossing crossing = new PortalCrossing();

    // The tick.
    private PortalWorld surroundings;
    private Portals portals;
    private double seconds;
    private TickBodies bodies;

    // The body that is advanced; its numbers in motion begin at an offset.
    private int body;
    private double[] motion;
    private int offset;
    private State state;
    private final Vector3d place = new Vector3d();
    /** The velocity, metres per second for a body without contacts, metres per part of a tick for others. */
    private final Vector3d velocity = new Vector3d();
    /** The acceleration in the same unit of time. */
    private final Vector3d pull = new Vector3d();
    /** The time left. */
    private double left;
    /** For each crossing of the tick, the fraction of the time that remained after it. */
    private final double[] fractionBeyond = new double[BodyPortalState.MOST];
    /** The work of gravity per kilogram over the blocked displacement, m²/s²; valid in {@link State#BLOCKED}. */
    private double blockedWork;

    // Scratch of one method each.
    private final double[] axes = new double[9];
    private final Vector3d displacement = new Vector3d();
    private final Vector3d blockedPath = new Vector3d();
    private final Vector3d direction = new Vector3d();
    private final Quaterniond orientation = new Quaterniond();

    ContinuousMotion(BodyTable table, Vec3 gravity, ContactSearch search, Poses poses) {
        this.gravity = gravity;
        this.search = search;
        narrow = search.narrow();
        this.poses = poses;
        collision = new ContinuousCollision(poses, narrow);
        rotation = new ContinuousRotation(table, poses, narrow, collision);
    }

    /**
     * Begins a tick: sets the displacements that the bodies would have without obstacles.
     *
     * @param pressed true for bodies that the solver moved
     */
    void begin(
            PortalWorld around,
            BodyInfluences influences,
            TickBodies bodiesOfTick,
            boolean[] pressed,
            SolverState motions,
            double tickSeconds) {
        surroundings = around;
        portals = around.portals();
        seconds = tickSeconds;
        bodies = bodiesOfTick;
        motion = bodies.motion;
        collision.begin(bodies.count, influences, seconds);
        double half = seconds * seconds / 2;
        for (int i = 0; i < bodies.count; i++) {
            int v = Bodies.STRIDE * i + Bodies.VELOCITY;
            if (pressed[i]) {
                int d = SolverState.STRIDE * i;
                collision.expect(i, motions.moved[d], motions.moved[d + 1], motions.moved[d + 2]);
            } else if (bodies.isAwake(i)) {
                collision.expect(
                        i,
                        motion[v] * seconds + gravity.x() * half,
                        motion[v + 1] * seconds + gravity.y() * half,
                        motion[v + 2] * seconds + gravity.z() * half);
            }
        }
    }

    /** Advances a body that had no contact in this tick. */
    void advanceFree(int itsBody, boolean falls) {
        select(itsBody);
        int v = offset + Bodies.VELOCITY;
        velocity.set(motion[v], motion[v + 1], motion[v + 2]);
        pull.set(gravity.x(), gravity.y(), gravity.z()).mul(falls ? 1 : 0);
        translate(seconds);
        write(velocity, v);
        if (state == State.BLOCKED && falls) {
            removeUnearnedSpeed();
        }
        rotation.turnFree(motion, body, place, surroundings, seconds);
    }

    /** Advances a body that the solver moved. */
    void advanceSolved(int itsBody, SolverState motions, boolean falls) {
        select(itsBody);
        int d = SolverState.STRIDE * body;
        System.arraycopy(motions.velocity, d, motion, offset + Bodies.VELOCITY, SolverState.STRIDE);
        velocity.set(motions.moved[d], motions.moved[d + 1], motions.moved[d + 2]);
        pull.zero();
        translate(1);
        if (state == State.BLOCKED && falls) {
            removeUnearnedSpeed();
        }
        int turned = d + SolverState.ANGULAR;
        for (int i = bodies.firstCrossing(body); i < bodies.crossings(body); i++) {
            PortalTransform transform = portals.transform(bodies.crossing(body, i));
            mapDirection(motion, offset + Bodies.VELOCITY, transform);
            mapDirection(motions.moved, turned, transform);
            if (falls) {
                fallBeyond(transform, fractionBeyond[i]);
            }
        }
        rotation.turnSolved(motion, body, place, surroundings, motions.moved, turned, seconds);
    }

    private void select(int itsBody) {
        body = itsBody;
        offset = Bodies.STRIDE * body;
    }

    /**
     * Removes the speed that gravity has given over a blocked displacement, which would add energy. The downward speed
     * is reduced by the energy of the missing height, v² = 2 g h.
     */
    private void removeUnearnedSpeed() {
        double[] m = motion;
        int v = offset + Bodies.VELOCITY;
        double g = Math.sqrt(gravity.dot(gravity));
        double down = (m[v] * gravity.x() + m[v + 1] * gravity.y() + m[v + 2] * gravity.z()) / g;
        if (blockedWork > 0 && down > 0) {
            double change = (Math.sqrt(Math.max(0, down * down - 2 * blockedWork)) - down) / g;
            m[v] += change * gravity.x();
            m[v + 1] += change * gravity.y();
            m[v + 2] += change * gravity.z();
        }
    }

    /**
     * Corrects the velocity for the part of the tick behind a portal, where gravity has the world's direction and not
     * the entry's rotated one.
     */
    private void fallBeyond(PortalTransform transform, double fraction) {
        direction.set(gravity.x(), gravity.y(), gravity.z());
        transform.direction(direction);
        int v = offset + Bodies.VELOCITY;
        motion[v] += fraction * seconds * (gravity.x() - direction.x);
        motion[v + 1] += fraction * seconds * (gravity.y() - direction.y);
        motion[v + 2] += fraction * seconds * (gravity.z() - direction.z);
    }

    private void mapDirection(double[] of, int at, PortalTransform transform) {
        direction.set(of[at], of[at + 1], of[at + 2]);
        transform.direction(direction);
        of[at] = direction.x;
        of[at + 1] = direction.y;
        of[at + 2] = direction.z;
    }

    private void write(Vector3d v, int at) {
        motion[at] = v.x;
        motion[at + 1] = v.y;
        motion[at + 2] = v.z;
    }

    /** Returns the displacement in a tick above which the body could tunnel through something. */
    private double farMetres() {
        return poses.leastHalf(body) / 2;
    }

    private boolean isFar() {
        return displacement.lengthSquared() > farMetres() * farMetres();
    }

    /** Advances from the body's place with {@link #velocity} and {@link #pull}, portal by portal. */
    private void translate(double duration) {
        place.set(motion[offset], motion[offset + 1], motion[offset + 2]);
        left = duration;
        state = State.MOVING;
        while (state == State.MOVING) {
            state = next(duration);
        }
        write(place, offset);
    }

    /** Moves to the next portal or to the end, and returns the state there. */
    private State next(double duration) {
        boolean enters = portals.size() > 0 && crossing.find(portals, place, velocity, pull, left);
        double t = enters ? crossing.seconds() : left;
        velocity.mul(t, displacement).fma(t * t / 2, pull);
        if (isFar() && isStopped(t)) {
            return State.BLOCKED;
        }
        if (!enters) {
            place.fma(t, velocity).fma(t * t / 2, pull);
            velocity.fma(t, pull);
            return State.ARRIVED;
        }
        if (!bodies.enter(body, crossing.portal())) {
            bodies.cutShort += slideAlongPortal() > LOST_METRES ? 1 : 0;
            return State.CUT_SHORT;
        }
        velocity.fma(t, pull);
        place.set(crossing.place());
        passPortal(portals.transform(crossing.portal()));
        left -= t;
        fractionBeyond[bodies.crossings(body) - 1] = left / duration;
        return left > 0 ? State.MOVING : State.ARRIVED;
    }

    /**
     * Moves along the plane of a portal a body that hovers there and passes it ever more often over ever shorter
     * distances.
     *
     * @return metres across the plane that are lost
     */
    private double slideAlongPortal() {
        Vec3 n = portals.portal(crossing.portal()).normal();
        double across = left * (velocity.x * n.x() + velocity.y * n.y() + velocity.z * n.z());
        velocity.mul(left, displacement).sub(across * n.x(), across * n.y(), across * n.z());
        place.fma(isFar() ? freeFraction() : 1, displacement);
        return Math.abs(across);
    }

    private void passPortal(PortalTransform transform) {
        transform.point(place);
        transform.direction(velocity);
        int q = offset + Bodies.ORIENTATION;
        orientation.set(motion[q], motion[q + 1], motion[q + 2], motion[q + 3]);
        transform.orientation(orientation);
        motion[q] = orientation.x;
        motion[q + 1] = orientation.y;
        motion[q + 2] = orientation.z;
        motion[q + 3] = orientation.w;
        mapDirection(motion, offset + Bodies.SPIN, transform);
    }

    /**
     * Returns true if an obstacle blocks the displacement; the body has then advanced as far as possible, or along what
     * it is deep inside.
     *
     * @param t time of the displacement
     */
    private boolean isStopped(double t) {
        double fraction = freeFraction();
        if (fraction >= 1) {
            return false;
        }
        velocity.mul(left, blockedPath);
        for (int i = 0; fraction == 0 && i < MOST_SLIDES; i++) {
            displacement.fma(-displacement.dot(collision.normal()), collision.normal());
            boolean enters = portals.size() > 0 && crossing.find(portals, place, displacement, direction.zero(), 1);
            fraction = enters ? 0 : freeFraction();
        }
        place.fma(fraction, displacement);
        if (pull.lengthSquared() > 0) {
            velocity.mul(fraction * t, blockedPath).fma(fraction * fraction * t * t / 2, pull);
            velocity.fma(fraction * t, pull);
        }
        blockedPath.fma(-fraction, displacement);
        blockedWork = gravity.x() * blockedPath.x + gravity.y() * blockedPath.y + gravity.z() * blockedPath.z;
        return true;
    }

    /** Returns the fraction of the displacement that is free of solids, bodies and characters. */
    private double freeFraction() {
        System.arraycopy(poses.axes, Poses.AXES * body, axes, 0, 9);
        boolean hasCrossed = bodies.hasCrossed(body);
        if (hasCrossed) {
            int q = offset + Bodies.ORIENTATION;
            poses.turn(body, motion[q], motion[q + 1], motion[q + 2], motion[q + 3]);
        }
        double depth = Math.min(MOST_DEPTH_METRES, farMetres() / 4);
        // The solver keeps apart solids and bodies with contacts, rotations included.
        boolean isSolved = !hasCrossed && displacement.length() <= search.farMetres(body);
        double free = collision.freeOfBodies(
                body, place, displacement, depth, hasCrossed, other -> isSolved && search.metOther(body, other));
        if (free > 0) {
            var hull = narrow.turnedHull(body);
            long mask = portals.size() == 0 ? 0 : surroundings.active(hull, place, displacement);
            boolean isSameWorld = isSolved && mask == bodies.active(body);
            free = Math.min(
                    free,
                    collision.freeOfSolids(
                            surroundings.openedFor(mask),
                            hull,
                            place,
                            displacement,
                            depth,
                            solid -> isSameWorld && search.metSolid(body, solid)));
        }
        System.arraycopy(axes, 0, poses.axes, Poses.AXES * body, 9);
        return free;
    }
}
