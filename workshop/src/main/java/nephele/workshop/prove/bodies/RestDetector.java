package nephele.workshop.prove.bodies;

import java.util.function.ObjIntConsumer;
import nephele.engine.collision.Collider;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Separation;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.level.Body;
import nephele.engine.math.Aabb;
import nephele.engine.math.bvh.ItemList;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * Decides whether a pile has come to rest: every body sleeps on something, or rolls or spins as a ball or capsule, or
 * is moved by one that does. A body falls asleep half a second after its mover has gone, and a body that rolls over a
 * groove leaves it for a moment; therefore the last {@link #WATCHED_SECONDS} are observed.
 */
final class RestDetector {
    static final double WATCHED_SECONDS = .6;

    private static final double TOUCHING_METRES = .005;

    /** The index that stands for a solid in place of a body's. */
    private static final int SOLID = -1;

    /** The greatest slip at the support of a ball or capsule that rolls or spins. */
    private static final double SLIP_METRES_PER_SECOND = .05;

    /** A slower ball or capsule moves nothing else. */
    private static final double MOVING_METRES_PER_SECOND = .01;

    private final BodyTable table;
    private final CollisionWorld world;
    private final Separation separation = new Separation();
    private final ItemList near = new ItemList();
    private final boolean[][] touching;
    /** True if a ball or capsule was observed to roll or spin on something. */
    private final boolean[] rolling;
    /** True if it was then fast enough to move something else. */
    private final boolean[] moving;

    private final Vector3d v = new Vector3d();
    private final Vector3d centre = new Vector3d();
    private final Vector3d normal = new Vector3d();
    private final Vector3d halfAxis = new Vector3d();
    private final Vector3d arm = new Vector3d();
    private final Vector3d slip = new Vector3d();
    private final Quaterniond turn = new Quaterniond();

    RestDetector(BodyTable table, CollisionWorld world) {
        this.table = table;
        this.world = world;
        touching = new boolean[table.size()][table.size()];
        rolling = new boolean[table.size()];
        moving = new boolean[table.size()];
    }

    /** Records contacts and rolling bodies at one tick. */
    void observe(Bodies bodies) {
        for (int i = 0; i < bodies.size(); i++) {
            if (!bodies.isAsleep(i)) {
                observe(bodies, i);
            }
        }
    }

    private void observe(Bodies bodies, int body) {
        boolean isRound = !(table.body(body) instanceof Body.Box) && !bodies.isFrozen(body);
        eachContact(bodies, body, (normal, other) -> {
            if (other != SOLID) {
                touching[body][other] = true;
            }
            rolling[body] |= isRound && slip(bodies, body, normal) < SLIP_METRES_PER_SECOND;
        });
        moving[body] |= rolling[body] && speed(bodies, body) > MOVING_METRES_PER_SECOND;
    }

    /** Returns true if all bodies have come to rest by the end of the observation. */
    boolean isAtRest(Bodies end) {
        boolean[] moved = moving.clone();
        spread(end, moved);
        boolean all = true;
        for (int i = 0; i < end.size(); i++) {
            all &= rolling[i] || moved[i] || end.isAsleep(i) && isHeld(end, i);
        }
        return all;
    }

    private boolean isHeld(Bodies bodies, int body) {
        boolean[] held = new boolean[1];
        eachContact(bodies, body, (normal, other) -> held[0] = true);
        return held[0];
    }

    /** Marks all awake bodies that touched a marked one, transitively. */
    private void spread(Bodies bodies, boolean[] moved) {
        for (int round = 0; round < moved.length; round++) {
            for (int i = 0; i < moved.length; i++) {
                for (int j = 0; j < moved.length; j++) {
                    moved[i] |= moved[j] && touching[i][j] && !bodies.isAsleep(i);
                }
            }
        }
    }

    /**
     * Returns the least slip in m/s of a ball's or capsule's surface, at its ends and its middle, on what it touches.
     */
    private double slip(Bodies bodies, int body, Vector3d normal) {
        double least = Double.POSITIVE_INFINITY;
        bodies.orientation(body, turn).transform(halfAxis.set(0, halfAxisMetres(body), 0));
        double along = halfAxis.dot(normal);
        for (int end = -1; end <= 1; end++) {
            if (end * along > TOUCHING_METRES - Math.abs(along)) {
                continue;
            }
            halfAxis.mul(end, arm).fma(-radiusMetres(body), normal);
            bodies.spin(body, v).cross(arm, slip);
            least = Math.min(least, slip.add(bodies.velocity(body, v)).length());
        }
        return least;
    }

    private double halfAxisMetres(int body) {
        return table.body(body) instanceof Body.Capsule capsule
                ? capsule.heightMetres() / 2 - capsule.radiusMetres()
                : 0;
    }

    private double radiusMetres(int body) {
        return table.reachMetres(body) - halfAxisMetres(body);
    }

    private double speed(Bodies bodies, int body) {
        double reach = table.reachMetres(body);
        return bodies.velocity(body, v).length() + reach * bodies.spin(body, v).length();
    }

    /**
     * Visits the contacts of a body.
     *
     * @param contact receives the normal, of unit length and away from the touched object, valid during the call, and the
     *     index of the other body or {@link #SOLID}
     */
    private void eachContact(Bodies bodies, int body, ObjIntConsumer<Vector3d> contact) {
        RoundedHull hull = table.hull(body, bodies.orientation(body, turn));
        bodies.centre(body, centre);
        world.overlapping(around(hull, centre), near);
        for (int i = 0; i < near.size(); i++) {
            visit(hull, world.collider(near.get(i)), SOLID, contact);
        }
        for (int i = 0; i < bodies.size(); i++) {
            if (i != body) {
                Vector3d at = bodies.centre(i, new Vector3d());
                visit(hull, table.collider(i, at, bodies.orientation(i, turn)), i, contact);
            }
        }
    }

    private static Aabb around(RoundedHull hull, Vector3d at) {
        return new Aabb(
                        at.x + hull.least(0),
                        at.y + hull.least(1),
                        at.z + hull.least(2),
                        at.x + hull.greatest(0),
                        at.y + hull.greatest(1),
                        at.z + hull.greatest(2))
                .grown(TOUCHING_METRES);
    }

    private void visit(RoundedHull hull, Collider against, int other, ObjIntConsumer<Vector3d> contact) {
        separation.measure(hull, centre.x, centre.y, centre.z, against);
        if (separation.metres() < TOUCHING_METRES) {
            contact.accept(normal.set(separation.normal()), other);
        }
    }
}
