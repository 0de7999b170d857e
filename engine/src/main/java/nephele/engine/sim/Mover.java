package nephele.engine.sim;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.SeamedWorld;
import nephele.engine.collision.Sweep;
import nephele.engine.collision.rigid.Bodies;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Sweeps and slides: how the player's capsule gets along the solids around it. The working set of one simulation. Moves
 * go on behind an aperture as if it were none: whoever moves looks afterwards whether the centre went through.
 */
final class Mover {
    static final int MAX_SLIDES = 5;
    /** Closer than this counts as there: a player at rest keeps the very bits of its place. */
    private static final double AT_REST_METRES = 1e-7;

    private static final Vector3dc STILL = new Vector3d();

    private final Sweep sweep = new Sweep();
    private final ContactPlanes planes = new ContactPlanes();
    private final Vector3d rest = new Vector3d();
    private final Vector3d down = new Vector3d();
    private final BodyObstacles bodies;
    private final Shoves shoves = new Shoves();
    private final Vector3d speed = new Vector3d();
    private SeamedWorld seamed;
    private long active;

    Mover(BodyObstacles bodies) {
        this.bodies = bodies;
    }

    /** What the following moves meet; a held body is none of it. */
    void enter(SeamedWorld entered, Bodies now, int heldBody) {
        seamed = entered;
        bodies.enter(entered, now, heldBody);
        active = 0;
        shoves.clear();
    }

    /** The centre has come out of a portal: what it met before lies elsewhere. */
    void arrive() {
        active = 0;
        shoves.clear();
    }

    /** The bodies that were met since the last arrival. */
    Shoves shoves() {
        return shoves;
    }

    /** The static solids that a shape meets here and on its way; a portal that was near stays open until the tick's end or arrival. */
    CollisionWorld world(RoundedHull shape, Vector3dc place, Vector3dc way) {
        active |= seamed.active(shape, place, way);
        return seamed.around(active);
    }

    CollisionWorld world(RoundedHull shape, Vector3dc place) {
        return world(shape, place, STILL);
    }

    /** The portals that were near since the last arrival, one bit each. */
    long active() {
        return active;
    }

    Sweep lastSweep() {
        return sweep;
    }

    /** The surfaces met by the last {@link #slide}. */
    ContactPlanes planes() {
        return planes;
    }

    /** Moves {@code place} along {@code way}, around whatever is met; at most {@link #MAX_SLIDES} surfaces. */
    void slide(RoundedHull shape, Vector3d place, Vector3dc way) {
        planes.clear();
        rest.set(way);
        for (int i = 0; i < MAX_SLIDES && rest.lengthSquared() > 0; i++) {
            boolean hit = meet(shape, place, rest);
            advance(place, rest, sweep.fraction());
            if (!hit) {
                return;
            }
            rest.mul(1 - sweep.fraction());
            planes.add(sweep.normal());
            planes.clip(rest);
        }
    }

    private boolean cast(RoundedHull shape, Vector3dc place, Vector3dc way) {
        world(shape, place, way);
        return sweep.cast(bodies.around(active, shape, place, way), shape, place, way);
    }

    /** As {@link #cast}, and a body that is met is told. */
    private boolean meet(RoundedHull shape, Vector3dc place, Vector3dc way) {
        boolean hit = cast(shape, place, way);
        if (hit && bodies.isBody(sweep.collider())) {
            shoves.met(sweep.normal(), bodies.velocity(sweep.collider(), sweep.point(), speed));
        }
        return hit;
    }

    /** Moves straight until something is met; true when it was. */
    boolean advanceUntilHit(RoundedHull shape, Vector3d place, Vector3dc way) {
        boolean hit = meet(shape, place, way);
        if (!hit || sweep.fraction() * way.length() > AT_REST_METRES) {
            advance(place, way, sweep.fraction());
        }
        return hit;
    }

    /** Whether anything stands in the way. */
    boolean isBlocked(RoundedHull shape, Vector3dc place, Vector3dc way) {
        return cast(shape, place, way);
    }

    /** Lowers {@code place} onto what lies at most {@code metres} below; stays where it is when nothing does. */
    boolean lower(RoundedHull shape, Vector3d place, double metres) {
        down.set(0, -metres, 0);
        if (!meet(shape, place, down)) {
            return false;
        }
        double way = metres * sweep.fraction();
        if (way > AT_REST_METRES) {
            place.y -= way;
        }
        return true;
    }

    private static void advance(Vector3d place, Vector3dc way, double fraction) {
        place.add(way.x() * fraction, way.y() * fraction, way.z() * fraction);
    }
}
