package nephele.host.playthrough;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.RayCast;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Separation;
import nephele.engine.math.Ray;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.portal.PathTrace;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The greatest length of a camera boom: through open portals, and a sphere's radius in front of the first solid. Solids
 * near the boom shorten it too, the more the nearer they are: so a corner that comes into its path does not cut it off
 * at once, and the length is a continuous function of eye and direction.
 */
final class CameraBoomReach {
    /**
     * Distance from solids; more than the near plane's corners need. At the eye itself the player's body keeps walls
     * away.
     */
    static final double CLEARANCE_METRES = 0.2;

    private static final double LEAST_CLEARANCE_METRES = 0.1;
    private static final double CLEARANCE_PER_METRE = 0.2;
    /**
     * Ratio of a solid's distance beside the boom to that along it, from which on it does not shorten the boom: tangent
     * of 10°.
     */
    private static final double FREE_TANGENT = 0.176;

    private static final double SAMPLE_METRES = 0.15;
    /** Range of a sample: solids farther from it are left to other samples; their effect fades from half of it on. */
    private static final double SIGHT_METRES = 0.6;

    private static final RoundedHull POINT = RoundedHull.sphere(0);
    private static final RoundedHull BALL = RoundedHull.sphere(SIGHT_METRES);
    private static final Vector3dc STILL = new Vector3d();

    private final CollisionWorld statics;
    private final RayCast cast = new RayCast();
    private final Separation separation = new Separation();
    private final ItemList found = new ItemList();
    private final double[] box = new double[6];
    private final Vector3d sample = new Vector3d();
    private final Vector3d direction = new Vector3d();
    private Portals asked;
    private PortalWorld portalWorld;
    private PathTrace trace;
    private double fullMetres;
    private double walkedMetres;
    private double freeMetres;

    CameraBoomReach(CollisionWorld statics) {
        this.statics = statics;
    }

    /** Returns the free fraction of a boom, 0 to 1. */
    double free(Portals portals, Vector3dc eye, Vector3dc boom) {
        fullMetres = boom.length();
        freeMetres = fullMetres;
        walkedMetres = 0;
        if (fullMetres > 0) {
            trace(portals).trace(eye, boom, this::leg);
        }
        return fullMetres > 0 ? Math.max(0, freeMetres) / fullMetres : 0;
    }

    /** Returns the path tracer that follows a boom to its end. */
    PathTrace trace(Portals portals) {
        if (portals != asked) {
            asked = portals;
            portalWorld = PortalWorld.of(statics, portals);
            trace = new PathTrace(portalWorld.portals(), this::freeOfSolids);
        }
        return trace;
    }

    /** Returns the fraction of a displacement that is free of solids, without portals. */
    double freeOfSolids(Vector3dc from, Vector3dc displacement) {
        var ray = new Ray(from.x(), from.y(), from.z(), displacement.x(), displacement.y(), displacement.z());
        return cast.cast(statics, ray, 1) ? cast.distance() : 1;
    }

    private void leg(Vector3dc from, Vector3dc displacement) {
        double length = displacement.length();
        displacement.div(Math.max(length, Double.MIN_NORMAL), direction);
        int steps = (int) Math.ceil(length / SAMPLE_METRES);
        for (int i = 0; i <= steps; i++) {
            double along = steps == 0 ? 0 : length * i / steps;
            if (walkedMetres + along - SIGHT_METRES > freeMetres) {
                break;
            }
            sample.set(from).fma(along, direction);
            shortenAtSample(walkedMetres + along);
        }
        walkedMetres += length;
    }

    private void shortenAtSample(double alongMetres) {
        CollisionWorld world = portalWorld.openedFor(portalWorld.active(BALL, sample, STILL));
        for (int axis = 0; axis < 3; axis++) {
            box[axis] = sample.get(axis) - SIGHT_METRES;
            box[3 + axis] = sample.get(axis) + SIGHT_METRES;
        }
        world.overlapping(box, 0, found);
        for (int i = 0; i < found.size(); i++) {
            separation.measure(POINT, sample.x, sample.y, sample.z, world.collider(found.get(i)));
            double metres = Math.max(0, separation.metres());
            double ahead = metres > 0 ? -metres * alongNormal() : 0;
            // Solids in front of the player are behind the eye in the boom's direction.
            if (metres < SIGHT_METRES && alongMetres + ahead >= 0) {
                double beside = Math.sqrt(Math.max(0, metres * metres - ahead * ahead));
                double fading = Math.max(0, metres / SIGHT_METRES - 0.5) * 2 * fullMetres;
                freeMetres = Math.min(freeMetres, limit(alongMetres + ahead, beside) + fading);
            }
        }
    }

    /** Returns the component along the boom of the direction away from the solid. */
    private double alongNormal() {
        return separation.normal().x() * direction.x
                + separation.normal().y() * direction.y
                + separation.normal().z() * direction.z;
    }

    /** Returns the greatest length of a boom that passes a solid's point at these distances along and beside it. */
    private double limit(double along, double beside) {
        double clearance = Math.min(CLEARANCE_METRES, LEAST_CLEARANCE_METRES + CLEARANCE_PER_METRE * along);
        if (beside <= clearance) {
            return along - Math.sqrt(clearance * clearance - beside * beside);
        }
        double slope = (beside - clearance) / Math.max(along, LEAST_CLEARANCE_METRES);
        return along + fullMetres * slope / FREE_TANGENT;
    }
}
