package nephele.engine.particle;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.level.Emitter;
import nephele.engine.math.Aabb;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;

/**
 * The ends of the drops of one emitter: at the first surface below, or in an open portal that lies there, behind which
 * they go on. A function of the drop, the time and the portals that are open.
 */
final class Rainfall {
    static final double SPLASH_SECONDS = 0.16;

    /** A portal is met before a surface that is no higher above it. */
    private static final double FLUSH_METRES = 0.3;

    /** Portals that are steeper catch hardly any rain. */
    private static final double LEAST_RISE = 0.05;

    private static final double SPLASH_HALF_WIDTH = 0.05;

    private final Emitter emitter;
    private final CollisionWorld world;
    private final ColumnHeights ends;
    private final List<PortalPaths> paths = new ArrayList<>();
    private final Vector3d place = new Vector3d();
    private final Vector3d velocity = new Vector3d();
    private Portals known = Portals.NONE;
    private Aabb bounds = Aabb.EMPTY;

    Rainfall(Emitter emitter, CollisionWorld world, ColumnHeights ends) {
        this.emitter = emitter;
        this.world = world;
        this.ends = ends;
    }

    /** Takes the portals of a frame; returns true if they are others than before. */
    boolean follow(Portals portals) {
        if (portals == known) {
            return false;
        }
        known = portals;
        paths.clear();
        bounds = Aabb.EMPTY;
        for (int i = 0; i < portals.size(); i++) {
            if (portals.isOpen(i) && isUnder(portals.portal(i))) {
                PortalPaths through = new PortalPaths(world, portals, i);
                paths.add(through);
                bounds = bounds.union(through.bounds());
            }
        }
        return true;
    }

    private boolean isUnder(Portal portal) {
        if (portal.normal().y() < LEAST_RISE) {
            return false;
        }
        Aabb column = Aabb.around(emitter.centre(), emitter.size());
        return column.overlaps(Aabb.of(portal.corners()).grown(FLUSH_METRES));
    }

    /** Returns a box around all paths behind portals; empty if there are none. */
    Aabb bounds() {
        return bounds;
    }

    /** Returns the time that a drop may last longer than its fall through the box. */
    double mostSecondsBeyond() {
        return (paths.isEmpty() ? 0 : PortalPaths.MOST_SECONDS) + (emitter.splashes() ? SPLASH_SECONDS : 0);
    }

    /**
     * Finds a drop that may have ended on its straight fall.
     *
     * @param falling whether {@code state} is that of a drop in the box; otherwise only its column is known
     * @param age seconds since its birth
     * @return false if nothing of it is visible
     */
    boolean at(long index, double age, boolean falling, ParticleState state) {
        double end = ends.at(state.x, state.z);
        PortalPaths through = through(state.x, state.z, end);
        if (through != null) {
            return intoPortal(index, age, falling, through, state);
        }
        if (falling && state.y - state.alongY > end) {
            return true;
        }
        double half = FallLaw.RAIN_HALF_LENGTH;
        double since = age - (emitter.size().y() / 2 - half - end) / Emitter.RAIN_METRES_PER_SECOND;
        boolean reaches = end > -emitter.size().y() / 2;
        return emitter.splashes() && reaches && splash(index, since, state.x, end, state.z, state);
    }

    private PortalPaths through(double x, double z, double end) {
        for (int i = 0; i < paths.size(); i++) {
            double height = paths.get(i)
                    .height(emitter.centre().x() + x, emitter.centre().z() + z);
            if (height - emitter.centre().y() > end - FLUSH_METRES) {
                return paths.get(i);
            }
        }
        return null;
    }

    private boolean intoPortal(long index, double age, boolean falling, PortalPaths through, ParticleState state) {
        double x = emitter.centre().x() + state.x;
        double z = emitter.centre().z() + state.z;
        double height = through.height(x, z);
        double fallen = emitter.centre().y() + emitter.size().y() / 2 - height;
        double since = age - fallen / Emitter.RAIN_METRES_PER_SECOND;
        if (since < 0) {
            return falling;
        }
        double over = through.after(x, height, z, since, place, velocity);
        place.sub(emitter.centre().x(), emitter.centre().y(), emitter.centre().z());
        if (over >= 0) {
            return emitter.splashes() && splash(index, over, place.x, place.y, place.z, state);
        }
        FallLaw.drop(emitter, index, state);
        state.place(place.x, place.y, place.z);
        double exposed = FallLaw.EXPOSED_SECONDS / 2;
        state.stretch(exposed * velocity.x, exposed * velocity.y, exposed * velocity.z);
        return true;
    }

    /** Writes the mist over the place where a drop has ended: it widens, rises a little and thins out. */
    private static boolean splash(long index, double since, double x, double y, double z, ParticleState state) {
        if (!(since >= 0 && since < SPLASH_SECONDS)) {
            return false;
        }
        double fraction = since / SPLASH_SECONDS;
        state.emission(0, 0, 0, 0);
        state.albedo = 1;
        state.turns = 0;
        state.halfWidth = SPLASH_HALF_WIDTH * (0.25 + 0.75 * Math.sqrt(fraction));
        state.place(x, y + 0.6 * state.halfWidth, z);
        state.stretch(0, 0, 0);
        state.opacity = 0.35 * (1 - fraction);
        state.picture = ParticlePicture.SPOT.number(index);
        return true;
    }
}
