package nephele.workshop.prove.portals;

import java.util.List;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.PathTrace;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerState;
import org.joml.Vector3d;

/**
 * Decides whether a player or body near portals is in a solid, without the static world opened at the portals. Straight
 * paths lead from its centre to points of its surface, through any aperture on them; at the end of each and half-offset
 * nothing may be solid.
 */
final class SeamedClearance {
    /**
     * The depth above which a point counts as in a solid; it covers the rounding of a surface point 10 km from the
     * origin.
     */
    private static final double TOLERANCE_METRES = 1e-6;

    private static final int AROUND = 6;

    private final CollisionWorld world;
    private final PathTrace trace;
    private final Vector3d path = new Vector3d();

    SeamedClearance(PortalRoom room) {
        world = room.world();
        trace = new PathTrace(room.portals(), Obstacles.NONE);
    }

    /** Returns the depth in metres of the deepest point in a solid; 0 for none. */
    double depth(PlayerState player) {
        Vec3 up = player.tilt().up();
        Vec3 side = perpendicular(up);
        Vec3 other = up.cross(side);
        double half = player.stance().heightMetres() / 2;
        double straight = half - PlayerDimensions.RADIUS_METRES;
        Vector3d centre = player.centre().toVector();
        double deepest = Math.max(depthAt(centre, up, half), depthAt(centre, up, -half));
        for (int i = 0; i < AROUND; i++) {
            double angle = 2 * Math.PI * i / AROUND;
            double a = PlayerDimensions.RADIUS_METRES * StrictMath.cos(angle);
            double b = PlayerDimensions.RADIUS_METRES * StrictMath.sin(angle);
            Vec3 out = Directions.combined(side, a, other, b);
            for (double height : new double[] {-straight, 0, straight}) {
                deepest = Math.max(deepest, depthAt(centre, out.addScaled(height, up), 1));
            }
        }
        return deepest;
    }

    /** Returns the same for the points at {@code offsets} from a body's centre. */
    double depth(Vector3d centre, List<Vector3d> offsets) {
        double deepest = 0;
        for (Vector3d offset : offsets) {
            deepest = Math.max(deepest, depthAt(centre, new Vec3(offset.x, offset.y, offset.z), 1));
        }
        return deepest;
    }

    private double depthAt(Vector3d centre, Vec3 direction, double metres) {
        double deepest = 0;
        for (double fraction : new double[] {0.5, 1}) {
            double length = fraction * metres;
            path.set(direction.x() * length, direction.y() * length, direction.z() * length);
            trace.trace(centre, path);
            deepest = Math.max(
                    deepest,
                    depthInSolids(
                            trace.place().x(), trace.place().y(), trace.place().z()));
        }
        return deepest;
    }

    private double depthInSolids(double x, double y, double z) {
        double deepest = 0;
        for (int i = 0; i < world.size(); i++) {
            Aabb box = world.collider(i).bounds();
            if (x < box.minX()
                    || x > box.maxX()
                    || y < box.minY()
                    || y > box.maxY()
                    || z < box.minZ()
                    || z > box.maxZ()) {
                continue;
            }
            double nearest = Double.POSITIVE_INFINITY;
            for (ConvexPolyhedron.Face face : world.collider(i).shape().faces()) {
                nearest = Math.min(nearest, -face.plane().signedDistance(x, y, z));
                if (nearest < TOLERANCE_METRES) {
                    break;
                }
            }
            if (nearest >= TOLERANCE_METRES) {
                deepest = Math.max(deepest, nearest);
            }
        }
        return deepest;
    }

    private static Vec3 perpendicular(Vec3 up) {
        return Math.abs(up.y()) > 0.9
                ? Directions.unit(up.cross(new Vec3(1, 0, 0)))
                : Directions.unit(up.cross(new Vec3(0, 1, 0)));
    }
}
