package nephele.engine.collision.rigid;

import nephele.engine.collision.Sweep;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * Moves one body to the end of the tick: along the exact arc p + v t + g t² / 2 when nothing pressed on it, along the
 * solver's displacement otherwise. Reused.
 */
final class Flight {
    private final BodyTable table;
    private final Vec3 gravity;
    private final NarrowPhase narrow;
    private final Poses poses;
    private final Spin spin = new Spin();
    private final Sweep sweep = new Sweep();
    private final Vector3d place = new Vector3d();
    private final Vector3d way = new Vector3d();
    private Surroundings surroundings;
    private double seconds;

    Flight(BodyTable table, Vec3 gravity, NarrowPhase narrow, Poses poses) {
        this.table = table;
        this.gravity = gravity;
        this.narrow = narrow;
        this.poses = poses;
    }

    void begin(Surroundings around, double tickSeconds) {
        surroundings = around;
        seconds = tickSeconds;
    }

    /** Nothing touched the body in this tick. */
    void fly(TickBodies bodies, int body, boolean falls) {
        double[] m = bodies.motion;
        int at = Bodies.STRIDE * body;
        double weight = falls ? 1 : 0;
        double half = seconds * seconds / 2 * weight;
        way.set(
                m[at + 7] * seconds + gravity.x() * half,
                m[at + 8] * seconds + gravity.y() * half,
                m[at + 9] * seconds + gravity.z() * half);
        double share = freeShare(bodies, body);
        double t = share * seconds;
        m[at] += m[at + 7] * t + gravity.x() * weight * t * t / 2;
        m[at + 1] += m[at + 8] * t + gravity.y() * weight * t * t / 2;
        m[at + 2] += m[at + 9] * t + gravity.z() * weight * t * t / 2;
        m[at + 7] += gravity.x() * weight * t;
        m[at + 8] += gravity.y() * weight * t;
        m[at + 9] += gravity.z() * weight * t;
        spin.turn(m, at, seconds, table, body);
    }

    /** The solver moved the body. */
    void follow(TickBodies bodies, int body, Motions motions) {
        double[] m = bodies.motion;
        int at = Bodies.STRIDE * body;
        int d = 6 * body;
        way.set(motions.moved[d], motions.moved[d + 1], motions.moved[d + 2]);
        double share = freeShare(bodies, body);
        m[at] += share * way.x;
        m[at + 1] += share * way.y;
        m[at + 2] += share * way.z;
        System.arraycopy(motions.velocity, d, m, at + Bodies.VELOCITY, 6);
        Spin.turnBy(m, at, motions.moved[d + 3], motions.moved[d + 4], motions.moved[d + 5]);
    }

    /** Which share of the way is free of solids; looked at only when the body could get past one unseen. */
    private double freeShare(TickBodies bodies, int body) {
        double limit = poses.leastHalf(body) / 4;
        if (way.lengthSquared() <= limit * limit) {
            return 1;
        }
        int at = Bodies.STRIDE * body;
        place.set(bodies.motion[at], bodies.motion[at + 1], bodies.motion[at + 2]);
        return sweep.cast(surroundings.around(0), narrow.turnedHull(body), place, way) ? sweep.fraction() : 1;
    }
}
