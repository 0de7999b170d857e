package nephele.engine.collision.rigid;

import nephele.engine.math.Vec3;
import nephele.engine.portal.Crossing;
import nephele.engine.portal.Passage;
import nephele.engine.portal.Portals;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * Moves one body to the end of the tick: along the exact arc p + v t + g t² / 2 when nothing pressed on it, along the
 * solver's displacement otherwise; through every portal that its centre enters, and not into what it could get past
 * unseen. Reused.
 */
final class Flight {
    /** A fast body may get so far into what it hits, and no deeper than an eighth of its thickness. */
    private static final double MOST_DEPTH_METRES = 5e-3;

    private final BodyTable table;
    private final Vec3 gravity;
    private final NarrowPhase narrow;
    private final Poses poses;
    private final Spin spin = new Spin();
    private final FastSweep sweep = new FastSweep();
    private final FastPairs pairs;
    private final Crossing crossing = new Crossing();
    private final Vector3d place = new Vector3d();
    private final Vector3d velocity = new Vector3d();
    private final Vector3d pull = new Vector3d();
    private final Vector3d way = new Vector3d();
    private final Vector3d turning = new Vector3d();
    private final Quaterniond orientation = new Quaterniond();
    private Surroundings surroundings;
    private Portals portals;
    private double seconds;

    Flight(BodyTable table, Vec3 gravity, NarrowPhase narrow, Poses poses) {
        this.table = table;
        this.gravity = gravity;
        this.narrow = narrow;
        this.poses = poses;
        pairs = new FastPairs(poses, narrow);
    }

    /** @param pressed whom the solver moved */
    void begin(Surroundings around, double tickSeconds, TickBodies bodies, boolean[] pressed, Motions motions) {
        surroundings = around;
        portals = around.portals();
        seconds = tickSeconds;
        pairs.clear(bodies.count);
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

    /** Nothing touched the body in this tick. */
    void fly(TickBodies bodies, int body, boolean falls) {
        double[] m = bodies.motion;
        int at = Bodies.STRIDE * body;
        velocity.set(m[at + 7], m[at + 8], m[at + 9]);
        pull.set(gravity.x(), gravity.y(), gravity.z()).mul(falls ? 1 : 0);
        travel(bodies, body, seconds);
        m[at + 7] = velocity.x;
        m[at + 8] = velocity.y;
        m[at + 9] = velocity.z;
        spin.turn(m, at, seconds, table, body);
    }

    /** The solver moved the body. */
    void follow(TickBodies bodies, int body, Motions motions) {
        double[] m = bodies.motion;
        int at = Bodies.STRIDE * body;
        int d = 6 * body;
        System.arraycopy(motions.velocity, d, m, at + Bodies.VELOCITY, 6);
        Spin.turnBy(m, at, motions.moved[d + 3], motions.moved[d + 4], motions.moved[d + 5]);
        velocity.set(motions.moved[d], motions.moved[d + 1], motions.moved[d + 2]);
        pull.zero();
        travel(bodies, body, 1);
        for (int i = 0; i < bodies.crossings(body); i++) {
            mapVelocity(m, at, portals.passage(bodies.crossing(body, i)));
        }
    }

    private void mapVelocity(double[] m, int at, Passage passage) {
        turning.set(m[at + 7], m[at + 8], m[at + 9]);
        passage.direction(turning);
        m[at + 7] = turning.x;
        m[at + 8] = turning.y;
        m[at + 9] = turning.z;
    }

    /** From the body's place with {@link #velocity} and {@link #pull}, portal by portal, for so long. */
    private void travel(TickBodies bodies, int body, double duration) {
        double[] m = bodies.motion;
        int at = Bodies.STRIDE * body;
        place.set(m[at], m[at + 1], m[at + 2]);
        double left = duration;
        while (left > 0) {
            boolean enters = portals.size() > 0 && crossing.find(portals, place, velocity, pull, left);
            double t = enters ? crossing.seconds() : left;
            velocity.mul(t, way).fma(t * t / 2, pull);
            double share = freeShare(bodies, body);
            if (share < 1) {
                advance(share * t);
                break;
            }
            if (!enters) {
                advance(t);
                break;
            }
            if (!bodies.enter(body, crossing.portal())) {
                break;
            }
            velocity.fma(t, pull);
            place.set(crossing.place());
            pass(m, at, portals.passage(crossing.portal()));
            left -= t;
        }
        m[at] = place.x;
        m[at + 1] = place.y;
        m[at + 2] = place.z;
    }

    private void advance(double t) {
        place.fma(t, velocity).fma(t * t / 2, pull);
        velocity.fma(t, pull);
    }

    private void pass(double[] m, int at, Passage passage) {
        passage.point(place);
        passage.direction(velocity);
        int q = at + Bodies.ORIENTATION;
        orientation.set(m[q], m[q + 1], m[q + 2], m[q + 3]);
        passage.orientation(orientation);
        m[q] = orientation.x;
        m[q + 1] = orientation.y;
        m[q + 2] = orientation.z;
        m[q + 3] = orientation.w;
        int w = at + Bodies.SPIN;
        turning.set(m[w], m[w + 1], m[w + 2]);
        passage.direction(turning);
        m[w] = turning.x;
        m[w + 1] = turning.y;
        m[w + 2] = turning.z;
    }

    /** Which share of the way is free of solids; looked at only when the body could get past one unseen. */
    private double freeShare(TickBodies bodies, int body) {
        double limit = poses.leastHalf(body) / 2;
        if (way.lengthSquared() <= limit * limit) {
            return 1;
        }
        double depth = Math.min(MOST_DEPTH_METRES, limit / 4);
        double free = 1;
        if (bodies.hasCrossed(body)) {
            double[] m = bodies.motion;
            int q = Bodies.STRIDE * body + Bodies.ORIENTATION;
            poses.turn(body, m[q], m[q + 1], m[q + 2], m[q + 3]);
        } else {
            free = pairs.free(body, bodies.count, way, depth);
        }
        var hull = narrow.turnedHull(body);
        long mask = portals.size() == 0 ? 0 : surroundings.active(hull, place, way);
        return Math.min(free, sweep.free(surroundings.around(mask), hull, place, way, depth));
    }
}
