package nephele.engine.sim.player;

import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.PlayerDimensions;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Applies {@link Assist#WALK_IN}: turns a walker beside or before a portal in a wall as little as leads its capsule
 * through, if its move intent points into the portal's plane.
 *
 * <p>The places of the plane where the capsule fits are an interval along the wall. Move intent and velocity are each
 * projected onto the nearest direction that leads into the interval: nothing gets faster, and who heads through
 * anyway keeps every bit. A walker that has passed the interval is not turned back.
 */
final class WalkIn {
    /** The sine of the least angle between move intent and plane, 10°. */
    private static final double LEAST_SINE = StrictMath.sin(Math.toRadians(10)) - 1e-9;

    /** Portals lean from upright by less than this: the sine. */
    private static final double MOST_LEAN = 0.3;

    /** Beside a portal, by up to so much more, a walker at the wall goes along it, over the trims of a frame. */
    private static final double BESIDE_METRES = 0.5;

    /** Distance between capsule and plane within which it acts; as far to the sides of the interval. */
    private static final double NEAR_METRES = 0.3;

    /** Trims of a frame that reach so far into the aperture are kept clear of, where there is room. */
    private static final double TRIM_METRES = 0.06;

    /** The least distance from the plane with which directions are taken. */
    private static final double LEAST_HEIGHT_METRES = 1e-3;

    /** A capsule below the aperture's edge is tried higher by parts of the greatest step. */
    private static final int LIFTS = 4;

    /** A walker straight ahead, to within the angle of this sine, may be turned to the other side of its intent... */
    private static final double STRAIGHT_SINE = StrictMath.sin(Math.toRadians(20));

    /** ...by an angle with at least this cosine. */
    private static final double STRAIGHT_COSINE = StrictMath.cos(Math.toRadians(45));

    private double alongX;
    private double alongZ;
    private double intoX;
    private double intoZ;
    private double height;
    private double least;
    private double most;
    private double turnedAlong;
    private double turnedInto;
    private final Vector3d turned = new Vector3d();

    /**
     * Turns move intent and velocity. Returns true if they were led.
     *
     * @param seconds of the tick: what is reached within it counts as near
     */
    boolean lead(PlayerMotion player, Portals portals, double seconds) {
        Vector3d intent = player.intent;
        int best = -1;
        double bestCosine = 0;
        for (int i = 0; i < portals.size(); i++) {
            double cosine = portals.isOpen(i) ? cosine(player, portals.portal(i), seconds) : 0;
            if (cosine > bestCosine) {
                bestCosine = cosine;
                best = i;
            }
        }
        if (best < 0) {
            return false;
        }
        cosine(player, portals.portal(best), seconds);
        if (isBeside(intent.length() * seconds)) {
            double along = intent.x * alongX + intent.z * alongZ;
            intent.set(turned.set(along * alongX, 0, along * alongZ));
        } else {
            intent.set(turned(intent.x, intent.z));
            player.velocity.set(turned(player.velocity.x, player.velocity.z));
        }
        return true;
    }

    /** Returns the cosine of the angle by which the move intent would be turned for a portal; 0 for none. */
    private double cosine(PlayerMotion player, Portal portal, double seconds) {
        Vec3 n = portal.normal();
        Vector3d intent = player.intent;
        double speed = intent.length();
        if (Math.abs(n.y()) > MOST_LEAN || speed == 0) {
            return 0;
        }
        double level = Math.sqrt(n.x() * n.x() + n.z() * n.z());
        intoX = -n.x() / level;
        intoZ = -n.z() / level;
        alongX = -intoZ;
        alongZ = intoX;
        Vector3d at = player.place;
        height = portal.inFront(at.x, at.y, at.z) / level;
        double into = (intent.x * intoX + intent.z * intoZ) / speed;
        double along = (intent.x * alongX + intent.z * alongZ) / speed;
        double step = speed * seconds;
        if (into < LEAST_SINE
                || height < 0
                || height > PlayerDimensions.RADIUS_METRES + NEAR_METRES + step
                || !fits(player, portal)) {
            return 0;
        }
        if (isBeside(step)) {
            boolean goesThere = least > 0 ? along > 0 : along < 0;
            boolean isNear = Math.max(least, -most) <= NEAR_METRES + step + BESIDE_METRES
                    && height <= PlayerDimensions.RADIUS_METRES + TRIM_METRES;
            return goesThere && isNear ? Math.abs(along) : 0;
        }
        if (leadsThrough(along, into)) {
            return 1;
        }
        turn(along, into);
        double cosine = turnedAlong * along + turnedInto * into;
        boolean isBack = along * turnedAlong < 0;
        return isBack && (Math.abs(along) > STRAIGHT_SINE || cosine < STRAIGHT_COSINE) ? 0 : cosine;
    }

    /** Returns true if the capsule is so far beside the interval that it goes along the wall first. */
    private boolean isBeside(double step) {
        return Math.max(least, -most) > NEAR_METRES + step;
    }

    /**
     * Sets the interval of displacements along the wall with which the capsule fits through the aperture, if need be
     * one step higher. Returns false if there is none.
     */
    private boolean fits(PlayerMotion player, Portal portal) {
        double core = player.stance().heightMetres() / 2 - PlayerDimensions.RADIUS_METRES;
        for (int i = 0; i <= LIFTS; i++) {
            double y = player.place.y + i * PlayerDimensions.STEP_METRES / LIFTS;
            least = Double.NEGATIVE_INFINITY;
            most = Double.POSITIVE_INFINITY;
            clip(portal, player.place, y - core);
            clip(portal, player.place, y + core);
            if (least <= most) {
                double clear = Math.min(TRIM_METRES, (most - least) / 2);
                least += clear;
                most -= clear;
                return true;
            }
        }
        return false;
    }

    /** Clips the interval to the displacements of a ball at a height with which it is within all edges. */
    private void clip(Portal portal, Vector3dc place, double y) {
        Aperture aperture = portal.aperture();
        double across = portal.across(place.x(), y, place.z());
        double upward = portal.upward(place.x(), y, place.z());
        Vec3 right = portal.frame().right();
        Vec3 up = portal.frame().up();
        double alongAcross = alongX * right.x() + alongZ * right.z();
        double alongUpward = alongX * up.x() + alongZ * up.z();
        for (int i = 0; i < aperture.corners(); i++) {
            double rate = aperture.edgeNormalX(i) * alongAcross + aperture.edgeNormalY(i) * alongUpward;
            double room = aperture.edgeDistance(i)
                    - PlayerDimensions.RADIUS_METRES
                    - aperture.edgeNormalX(i) * across
                    - aperture.edgeNormalY(i) * upward;
            if (rate > 1e-9) {
                most = Math.min(most, room / rate);
            } else if (rate < -1e-9) {
                least = Math.max(least, room / rate);
            } else if (room < 0) {
                most = Double.NEGATIVE_INFINITY;
            }
        }
    }

    /** Returns true if a direction leads into the interval. */
    private boolean leadsThrough(double along, double into) {
        double from = Math.max(height, LEAST_HEIGHT_METRES);
        return into > 0 && along * from <= most * into && along * from >= least * into;
    }

    /** Sets the unit direction into the interval that is nearest to one that does not lead there. */
    private void turn(double along, double into) {
        double from = Math.max(height, LEAST_HEIGHT_METRES);
        double edge = into > 0 ? Math.max(least, Math.min(most, along * from / into)) : along > 0 ? most : least;
        double length = Math.sqrt(edge * edge + from * from);
        turnedAlong = edge / length;
        turnedInto = from / length;
    }

    /** Returns a horizontal velocity, projected onto the nearest direction that leads into the interval. */
    private Vector3dc turned(double x, double z) {
        double along = x * alongX + z * alongZ;
        double into = x * intoX + z * intoZ;
        turned.set(x, 0, z);
        if (leadsThrough(along, into)) {
            return turned;
        }
        turn(along, into);
        double speed = Math.max(0, along * turnedAlong + into * turnedInto);
        double alongSpeed = speed * turnedAlong;
        double intoSpeed = speed * turnedInto;
        return turned.set(alongSpeed * alongX + intoSpeed * intoX, 0, alongSpeed * alongZ + intoSpeed * intoZ);
    }
}
