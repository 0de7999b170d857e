package nephele.workshop.prove.geometry;

import java.util.List;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerState;
import org.joml.Vector3d;

/**
 * Distances computed from every corner, edge and face, without iteration. Slow; it shares no code with the code under
 * test.
 */
public final class BruteForce {
    private BruteForce() {}

    /**
     * Returns the distance in metres between the player's capsule and the nearest solid; negative if it penetrates one.
     */
    public static double gap(PlayerState player, CollisionWorld world) {
        Vec3 feet = player.feet();
        double half = player.stance().heightMetres() / 2 - PlayerDimensions.RADIUS_METRES;
        double centre = feet.y() + player.stance().centreAboveFeet();
        Vector3d low = new Vector3d(feet.x(), centre - half, feet.z());
        Vector3d high = new Vector3d(feet.x(), centre + half, feet.z());
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < world.size(); i++) {
            least = Math.min(least, distance(low, high, world.collider(i).shape()));
        }
        return least - PlayerDimensions.RADIUS_METRES;
    }

    /** Returns the distance between the segment a–b and the solid; 0 if they intersect. */
    public static double distance(Vector3d a, Vector3d b, ConvexPolyhedron solid) {
        if (meets(a, b, solid)) {
            return 0;
        }
        double least = Double.POSITIVE_INFINITY;
        for (ConvexPolyhedron.Face face : solid.faces()) {
            least = Math.min(least, Math.min(fromFace(a, face), fromFace(b, face)));
            List<Vec3> ring = face.polygon();
            for (int i = 0; i < ring.size(); i++) {
                Vector3d c = ring.get(i).toVector();
                Vector3d d = ring.get((i + 1) % ring.size()).toVector();
                least = Math.min(least, betweenSegments(a, b, c, d));
            }
        }
        return least;
    }

    private static boolean meets(Vector3d a, Vector3d b, ConvexPolyhedron solid) {
        double enter = 0;
        double leave = 1;
        for (ConvexPolyhedron.Face face : solid.faces()) {
            double atA = face.plane().signedDistance(a.x, a.y, a.z);
            double atB = face.plane().signedDistance(b.x, b.y, b.z);
            if (atA > 0 && atB > 0) {
                return false;
            } else if (atA > 0) {
                enter = Math.max(enter, atA / (atA - atB));
            } else if (atB > 0) {
                leave = Math.min(leave, atA / (atA - atB));
            }
        }
        return enter <= leave;
    }

    private static double fromFace(Vector3d p, ConvexPolyhedron.Face face) {
        double height = face.plane().signedDistance(p.x, p.y, p.z);
        Vector3d normal = face.plane().normal().toVector();
        Vector3d foot = new Vector3d(p).sub(new Vector3d(normal).mul(height));
        List<Vec3> ring = face.polygon();
        for (int i = 0; i < ring.size(); i++) {
            Vector3d c = ring.get(i).toVector();
            Vector3d edge = ring.get((i + 1) % ring.size()).toVector().sub(c);
            if (edge.cross(new Vector3d(foot).sub(c)).dot(normal) < 0) {
                return Double.POSITIVE_INFINITY;
            }
        }
        return Math.abs(height);
    }

    /**
     * Returns the distance of two segments. The minimum of a quadratic over a square is inside or on one of the four
     * sides.
     */
    static double betweenSegments(Vector3d a, Vector3d b, Vector3d c, Vector3d d) {
        double least = Math.min(
                Math.min(fromSegment(a, c, d), fromSegment(b, c, d)),
                Math.min(fromSegment(c, a, b), fromSegment(d, a, b)));
        Vector3d u = new Vector3d(b).sub(a);
        Vector3d v = new Vector3d(d).sub(c);
        Vector3d w = new Vector3d(a).sub(c);
        double determinant = u.dot(u) * v.dot(v) - u.dot(v) * u.dot(v);
        if (determinant > 1e-12 * u.dot(u) * v.dot(v)) {
            double s = (u.dot(v) * v.dot(w) - v.dot(v) * u.dot(w)) / determinant;
            double t = (u.dot(u) * v.dot(w) - u.dot(v) * u.dot(w)) / determinant;
            if (s > 0 && s < 1 && t > 0 && t < 1) {
                least = Math.min(least, w.add(u.mul(s)).sub(v.mul(t)).length());
            }
        }
        return least;
    }

    private static double fromSegment(Vector3d p, Vector3d a, Vector3d b) {
        Vector3d u = new Vector3d(b).sub(a);
        double t = u.lengthSquared() == 0 ? 0 : new Vector3d(p).sub(a).dot(u) / u.lengthSquared();
        return u.mul(Math.max(0, Math.min(1, t))).add(a).distance(p);
    }
}
