package nephele.engine.sim.player;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Sweep;
import nephele.engine.collision.rigid.body.Bodies;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Sweeps and slides the player's capsule along the solids around it. The working set of one simulation. Moves continue
 * behind an aperture as if it were open space; the caller tests afterwards whether the centre crossed it.
 */
final class CharacterMover {
    static final int MAX_SLIDES = 5;
    /** A shorter advance is omitted: a player at rest keeps its place bit for bit. */
    private static final double AT_REST_METRES = 1e-7;

    private final Sweep sweep = new Sweep();
    private final ContactPlanes planes = new ContactPlanes();
    private final Vector3d rest = new Vector3d();
    private final Vector3d down = new Vector3d();
    private final BodyObstacles bodies;
    private final BodyPushes pushes = new BodyPushes();
    private final Vector3d speed = new Vector3d();
    private PortalWorld portalWorld;
    private long active;

    CharacterMover(BodyObstacles bodies) {
        this.bodies = bodies;
    }

    /** Starts a tick: sets the world and the bodies of the following moves; {@code heldBody} is no obstacle. */
    void enter(PortalWorld entered, Bodies now, int heldBody) {
        portalWorld = entered;
        bodies.enter(entered, now, heldBody);
        active = 0;
        pushes.clear();
    }

    /** Resets the contacts and active portals after the centre has come out of a portal, into another space. */
    void resetAfterPortal() {
        active = 0;
        pushes.clear();
    }

    /** Returns the contacts with bodies since the last arrival. */
    BodyPushes pushes() {
        return pushes;
    }

    /**
     * Returns the static solids near a shape and its path. A portal that was near stays open until the end of the tick
     * or the next arrival.
     */
    CollisionWorld world(RoundedHull shape, Vector3dc place, Vector3dc path) {
        active |= portalWorld.active(shape, place, path);
        return portalWorld.openedFor(active);
    }

    CollisionWorld world(RoundedHull shape, Vector3dc place) {
        active |= portalWorld.active(shape, place);
        return portalWorld.openedFor(active);
    }

    /** Returns the portals that were near since the last arrival, one bit each. */
    long active() {
        return active;
    }

    Sweep lastSweep() {
        return sweep;
    }

    /** Returns the planes hit by the last {@link #slide}. */
    ContactPlanes planes() {
        return planes;
    }

    /** Moves {@code place} along {@code path} and slides along each surface hit, at most {@link #MAX_SLIDES}. */
    void slide(RoundedHull shape, Vector3d place, Vector3dc path) {
        planes.clear();
        rest.set(path);
        for (int i = 0; i < MAX_SLIDES && rest.lengthSquared() > 0; i++) {
            boolean hit = castAndRecord(shape, place, rest);
            advance(place, rest, sweep.fraction());
            if (!hit) {
                return;
            }
            rest.mul(1 - sweep.fraction());
            planes.add(sweep.normal());
            planes.removeComponentsInto(rest);
        }
    }

    private boolean cast(RoundedHull shape, Vector3dc place, Vector3dc path) {
        world(shape, place, path);
        return sweep.cast(bodies.around(active, shape, place, path), shape, place, path);
    }

    /** Sweeps as {@link #cast} does, and records a hit body as a contact. */
    private boolean castAndRecord(RoundedHull shape, Vector3dc place, Vector3dc path) {
        boolean hit = cast(shape, place, path);
        if (hit && bodies.isBody(sweep.collider())) {
            pushes.met(sweep.normal(), bodies.velocity(sweep.collider(), sweep.point(), speed));
        }
        return hit;
    }

    /** Moves straight until a hit. Returns true if there was one. */
    boolean advanceUntilHit(RoundedHull shape, Vector3d place, Vector3dc path) {
        boolean hit = castAndRecord(shape, place, path);
        if (!hit || sweep.fraction() * path.length() > AT_REST_METRES) {
            advance(place, path, sweep.fraction());
        }
        return hit;
    }

    /** Returns true if anything blocks the path. */
    boolean isBlocked(RoundedHull shape, Vector3dc place, Vector3dc path) {
        return cast(shape, place, path);
    }

    /**
     * Lowers {@code place} onto a surface at most {@code metres} below. Returns false, with the place unchanged, if
     * there is none.
     */
    boolean lower(RoundedHull shape, Vector3d place, double metres) {
        down.set(0, -metres, 0);
        if (!castAndRecord(shape, place, down)) {
            return false;
        }
        double path = metres * sweep.fraction();
        if (path > AT_REST_METRES) {
            place.y -= path;
        }
        return true;
    }

    private static void advance(Vector3d place, Vector3dc path, double fraction) {
        place.add(path.x() * fraction, path.y() * fraction, path.z() * fraction);
    }
}
