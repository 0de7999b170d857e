package nephele.app.prove;

import nephele.engine.collision.rigid.Bodies;
import nephele.engine.collision.rigid.BodyTable;
import nephele.engine.level.Body;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * Whether a pile has come to rest: every body is asleep, or rolls or spins as a ball or capsule, or is in touch with one
 * that does.
 */
final class RestJudge {
    /** No part of a body that only rolls or spins goes up or down faster than this. */
    private static final double LEVEL_METRES_PER_SECOND = .05;

    /** A ball or capsule slower than this moves nothing else. */
    private static final double MOVING_METRES_PER_SECOND = .01;

    private static final double TOUCHING_METRES = .005;

    private final BodyTable table;
    private final BodyDepth distance;
    private final Vector3d v = new Vector3d();
    private final Vector3d axis = new Vector3d();
    private final Quaterniond turn = new Quaterniond();

    RestJudge(BodyTable table, BodyDepth distance) {
        this.table = table;
        this.distance = distance;
    }

    boolean isAtRest(Bodies bodies) {
        boolean[] explained = new boolean[bodies.size()];
        boolean[] moves = new boolean[bodies.size()];
        for (int i = 0; i < bodies.size(); i++) {
            boolean rolls = rolls(bodies, i);
            explained[i] = bodies.isAsleep(i) || rolls;
            moves[i] = rolls && speed(bodies, i) > MOVING_METRES_PER_SECOND;
        }
        spread(bodies, moves);
        boolean all = true;
        for (int i = 0; i < bodies.size(); i++) {
            all &= explained[i] || moves[i];
        }
        return all;
    }

    /** Marks all awake bodies that touch a marked one, and those that touch these. */
    private void spread(Bodies bodies, boolean[] moved) {
        for (int round = 0; round < bodies.size(); round++) {
            for (int i = 0; i < bodies.size(); i++) {
                for (int j = 0; j < bodies.size(); j++) {
                    moved[i] |= i != j
                            && moved[j]
                            && !bodies.isAsleep(i)
                            && distance.gapMetres(bodies, i, j) < TOUCHING_METRES;
                }
            }
        }
    }

    private boolean rolls(Bodies bodies, int body) {
        if (bodies.isAsleep(body) || bodies.isFrozen(body) || table.body(body) instanceof Body.Box) {
            return false;
        }
        double rises = Math.abs(bodies.velocity(body, v).y);
        if (table.body(body) instanceof Body.Capsule capsule) {
            double halfAxis = capsule.heightMetres() / 2 - capsule.radiusMetres();
            bodies.orientation(body, turn).transform(axis.set(0, halfAxis, 0));
            bodies.spin(body, v).cross(axis);
            rises += Math.abs(v.y);
        }
        return rises < LEVEL_METRES_PER_SECOND;
    }

    private double speed(Bodies bodies, int body) {
        double reach = table.reachMetres(body);
        return bodies.velocity(body, v).length() + reach * bodies.spin(body, v).length();
    }
}
