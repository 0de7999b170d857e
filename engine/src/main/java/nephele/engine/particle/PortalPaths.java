package nephele.engine.particle;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.RayCast;
import nephele.engine.level.Emitter;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.portal.PortalCrossing;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;

/**
 * The paths of drops that fall into one open portal: how long each lasts behind it, until a surface ends it or another
 * portal takes it on. The aperture is divided into cells, and a path is followed from the middle of each; where a drop is
 * on its path follows from its own place.
 */
final class PortalPaths {
    /** No path behind the first portal takes longer. */
    static final double MOST_SECONDS = 2.5;

    private static final int CELLS = 10;
    private static final int MOST_LEGS = 4;
    private static final double FINAL_SPEED = Emitter.RAIN_METRES_PER_SECOND;
    private static final double DRAG_PER_SECOND = ParticleLaw.GRAVITY / FINAL_SPEED;
    private static final double PIECE_SECONDS = 1.0 / 40;
    private static final double FROM_WALL_METRES = 2e-3;

    private final Portals portals;
    private final int entry;
    private final double halfAcross;
    private final double halfUp;
    private final double[] ends = new double[CELLS * CELLS * MOST_LEGS];
    /** The portal at the end of a leg; {@link Portals#CLOSED} where a surface ends it, or the time. */
    private final int[] next = new int[CELLS * CELLS * MOST_LEGS];

    /** Where the present leg begins, and the velocity there. */
    private final Vector3d legPlace = new Vector3d();

    private final Vector3d legVelocity = new Vector3d();
    private final Vector3d place = new Vector3d();
    private final Vector3d velocity = new Vector3d();
    private final Vector3d step = new Vector3d();
    private Aabb bounds = Aabb.EMPTY;

    PortalPaths(CollisionWorld world, Portals portals, int entry) {
        this.portals = portals;
        this.entry = entry;
        Portal portal = portals.portal(entry);
        halfAcross = portal.aperture().widthMetres() / 2;
        halfUp = portal.aperture().heightMetres() / 2;
        for (int cell = 0; cell < CELLS * CELLS; cell++) {
            Vec3 middle = portal.world(
                    halfAcross * (2 * (cell % CELLS + 0.5) / CELLS - 1),
                    halfUp * (2 * (cell / CELLS + 0.5) / CELLS - 1),
                    0);
            follow(world, cell, middle);
        }
    }

    private void follow(CollisionWorld world, int cell, Vec3 middle) {
        place.set(middle.x(), middle.y(), middle.z());
        velocity.set(0, -Emitter.RAIN_METRES_PER_SECOND, 0);
        double left = MOST_SECONDS;
        int through = entry;
        for (int i = 0; i < MOST_LEGS && through != Portals.CLOSED; i++) {
            enter(through);
            int at = MOST_LEGS * cell + i;
            next[at] = Portals.CLOSED;
            ends[at] = end(world, left, at);
            left -= ends[at];
            through = next[at];
            velocityOnLeg(ends[at], velocity);
            placeOnLeg(ends[at], place);
        }
    }

    /** Begins a leg behind a portal that was entered at {@link #place}. */
    private void enter(int portal) {
        portals.transform(portal).point(place);
        portals.transform(portal).direction(velocity);
        Vec3 out = portals.portal(portals.partner(portal)).normal();
        legPlace.set(place.fma(FROM_WALL_METRES, out.toVector()));
        legVelocity.set(velocity);
    }

    /**
     * Puts the place on the present leg: drag in proportion to the difference from the final velocity brings a drop back to
     * that, v(t) = v_f + (v_0 − v_f) e^(−kt) with k = g / |v_f|.
     */
    private Vector3d placeOnLeg(double seconds, Vector3d out) {
        double left = -Math.expm1(-DRAG_PER_SECOND * seconds) / DRAG_PER_SECOND;
        return out.set(
                legPlace.x + legVelocity.x * left,
                legPlace.y - FINAL_SPEED * seconds + (legVelocity.y + FINAL_SPEED) * left,
                legPlace.z + legVelocity.z * left);
    }

    private Vector3d velocityOnLeg(double seconds, Vector3d out) {
        double left = Math.exp(-DRAG_PER_SECOND * seconds);
        return out.set(legVelocity.x * left, (legVelocity.y + FINAL_SPEED) * left - FINAL_SPEED, legVelocity.z * left);
    }

    private double end(CollisionWorld world, double most, int at) {
        RayCast cast = new RayCast();
        Ray ray = Ray.reusable();
        PortalCrossing crossing = new PortalCrossing();
        Vector3d from = placeOnLeg(0, new Vector3d());
        for (double seconds = 0; seconds < most; seconds += PIECE_SECONDS) {
            placeOnLeg(seconds + PIECE_SECONDS, step).sub(from);
            double metres = step.length();
            ray.aim(from.x, from.y, from.z, step.x / metres, step.y / metres, step.z / metres);
            double free = cast.cast(world, ray, metres) ? cast.distance() : Double.POSITIVE_INFINITY;
            boolean crosses = crossing.find(portals, from, step, new Vector3d(), 1);
            if (crosses && crossing.seconds() * metres <= free + FROM_WALL_METRES) {
                next[at] = crossing.portal();
                return seconds + crossing.seconds() * PIECE_SECONDS;
            }
            from.add(step);
            include(from);
            if (free < metres) {
                return seconds + free / metres * PIECE_SECONDS;
            }
        }
        return most;
    }

    private void include(Vector3d point) {
        bounds = bounds.union(new Aabb(point.x, point.y, point.z, point.x, point.y, point.z));
    }

    /** Returns a box of the world that no drop behind the portal leaves by more than its length. */
    Aabb bounds() {
        return bounds;
    }

    /** Returns the height of the portal's plane in a column of the world; NaN where the column misses the aperture. */
    double height(double x, double z) {
        Portal portal = portals.portal(entry);
        Vec3 normal = portal.normal();
        Vec3 centre = portal.centre();
        double y = centre.y() - (normal.x() * (x - centre.x()) + normal.z() * (z - centre.z())) / normal.y();
        return portal.aperture().contains(portal.across(x, y, z), portal.upward(x, y, z)) ? y : Double.NaN;
    }

    /**
     * Finds where a drop is that has entered the portal.
     *
     * @param out receives the place in the world; the end of the path if it is over
     * @param speed receives the velocity
     * @return seconds since the end of the path; negative before
     */
    double after(double x, double y, double z, double seconds, Vector3d out, Vector3d speed) {
        Portal portal = portals.portal(entry);
        double across = column(portal.across(x, y, z) / halfAcross);
        double up = column(portal.upward(x, y, z) / halfUp);
        place.set(x, y, z);
        velocity.set(0, -Emitter.RAIN_METRES_PER_SECOND, 0);
        double left = seconds;
        int through = entry;
        int nearest = (int) (across + 0.5) + CELLS * (int) (up + 0.5);
        for (int i = 0; ; i++) {
            enter(through);
            int onward = next[MOST_LEGS * nearest + i];
            double end = end(across, up, nearest, i);
            if (left < end || onward == Portals.CLOSED || i == MOST_LEGS - 1) {
                placeOnLeg(Math.min(left, end), out);
                velocityOnLeg(Math.min(left, end), speed);
                return left - end;
            }
            left -= end;
            placeOnLeg(end, place);
            velocityOnLeg(end, velocity);
            through = onward;
        }
    }

    /** Returns a place among the middles of cells, 0 for the first and CELLS − 1 for the last. */
    private static double column(double fraction) {
        return Math.min(CELLS - 1.001, Math.max(0, (fraction + 1) / 2 * CELLS - 0.5));
    }

    /** Returns when a leg ends: interpolated between cells whose paths end alike, else that of the nearest one. */
    private double end(double across, double up, int nearest, int number) {
        int low = MOST_LEGS * ((int) across + CELLS * (int) up) + number;
        int right = low + MOST_LEGS;
        int above = low + MOST_LEGS * CELLS;
        int both = above + MOST_LEGS;
        double least = Math.min(Math.min(ends[low], ends[right]), Math.min(ends[above], ends[both]));
        double most = Math.max(Math.max(ends[low], ends[right]), Math.max(ends[above], ends[both]));
        boolean isAlike = next[low] == next[right]
                && next[low] == next[above]
                && next[low] == next[both]
                && most - least < 2 * PIECE_SECONDS;
        if (!isAlike) {
            return ends[MOST_LEGS * nearest + number];
        }
        double x = across - (int) across;
        double y = up - (int) up;
        double first = ends[low] + x * (ends[right] - ends[low]);
        double second = ends[above] + x * (ends[both] - ends[above]);
        return first + y * (second - first);
    }
}
