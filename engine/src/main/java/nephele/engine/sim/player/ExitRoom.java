package nephele.engine.sim.player;

import nephele.engine.collision.Collider;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Separation;
import nephele.engine.math.Aabb;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.portal.Portal;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.PlayerDimensions;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Applies {@link Assist#EXIT_ROOM}: eases a player that has come out of a portal sideways off the walls and edges before
 * it. It moves only across the direction of a held key, and never back towards the portal.
 */
final class ExitRoom {
    /** The distance that it makes. */
    private static final double ROOM_METRES = 0.2;

    private static final double MOST_METRES_PER_SECOND = 1;

    /** The speed for each metre that is missing, 1/s. */
    private static final double RATE_PER_SECOND = 8;

    /** The player counts as at the exit up to so far before it, and aside of its aperture. */
    private static final double BEFORE_METRES = 1;

    /** Solids that are nearest at most so far before the exit's plane are its wall and its frame. */
    private static final double FRAME_METRES = 0.05;

    /** Surfaces that are flatter are floors, ceilings and slopes: the least horizontal part of a unit normal. */
    private static final double LEAST_LEVEL = 0.7;

    private final Separation separation = new Separation();
    private final ItemList near = new ItemList();
    private final Vector3d easing = new Vector3d();
    private final Vector3d axis = new Vector3d();

    /** Returns the horizontal velocity of the player's easing, m/s; zero if it has room or is away from the exit. */
    Vector3dc easing(PlayerMotion player, Portal exit, CollisionWorld world) {
        easing.zero();
        if (!isAt(player, exit)) {
            return easing;
        }
        RoundedHull shape = player.shape();
        Vector3d at = player.place;
        world.overlapping(
                new Aabb(
                        at.x + shape.least(0) - ROOM_METRES,
                        at.y + shape.least(1),
                        at.z + shape.least(2) - ROOM_METRES,
                        at.x + shape.greatest(0) + ROOM_METRES,
                        at.y + shape.greatest(1),
                        at.z + shape.greatest(2) + ROOM_METRES),
                near);
        for (int i = 0; i < near.size(); i++) {
            Collider solid = world.collider(near.get(i));
            separation.measure(shape, at.x, at.y, at.z, solid);
            double missing = ROOM_METRES - separation.metres();
            axis.set(separation.normal().x(), 0, separation.normal().z());
            if (missing > 0 && axis.length() > LEAST_LEVEL && isBefore(exit)) {
                raise(axis.normalize(), missing * RATE_PER_SECOND);
            }
        }
        axis.set(exit.normal().x(), 0, exit.normal().z());
        remove(axis, Math.min(0, easing.dot(axis)));
        remove(axis.set(player.intent), easing.dot(axis));
        double speed = easing.length();
        return speed > MOST_METRES_PER_SECOND ? easing.mul(MOST_METRES_PER_SECOND / speed) : easing;
    }

    private static boolean isAt(PlayerMotion player, Portal exit) {
        Vector3d at = player.place;
        double before = exit.inFront(at.x, at.y, at.z);
        double across = exit.across(at.x, at.y, at.z);
        double upward = exit.upward(at.x, at.y, at.z);
        return before >= 0
                && before <= BEFORE_METRES
                && exit.aperture().outside(across, upward) <= BEFORE_METRES
                && player.velocity.length() <= PlayerDimensions.RUN_METRES_PER_SECOND + 1e-9;
    }

    private boolean isBefore(Portal exit) {
        return exit.inFront(separation.onCollider(0), separation.onCollider(1), separation.onCollider(2))
                > FRAME_METRES;
    }

    /** Raises the velocity along a unit vector to a least value. */
    private void raise(Vector3dc along, double least) {
        easing.fma(Math.max(0, least - easing.dot(along)), along);
    }

    /** Removes a fraction of a vector from the velocity; {@code dot} is the scalar product of both that is taken out. */
    private void remove(Vector3dc vector, double dot) {
        double square = vector.lengthSquared();
        if (square > 0) {
            easing.fma(-dot / square, vector);
        }
    }
}
