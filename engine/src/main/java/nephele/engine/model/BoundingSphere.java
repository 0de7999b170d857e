package nephele.engine.model;

import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/** A sphere that contains every vertex of a mesh. */
public record BoundingSphere(Vec3 centre, double radius) {
    private static final int STEPS = 32;

    /**
     * Returns a sphere close to the smallest one. The centre starts in the middle of the box and repeatedly moves 1 /
     * (i + 1) of the distance towards the farthest vertex (Bădoiu and Clarkson, 2003, algorithm 1); the best centre is
     * kept.
     */
    public static BoundingSphere of(Mesh mesh) {
        return of(mesh.positions());
    }

    /** Returns a sphere as {@link #of(Mesh)} does. @param positions x, y, z of each vertex */
    public static BoundingSphere of(float[] positions) {
        if (positions.length == 0) {
            return new BoundingSphere(Vec3.ZERO, 0);
        }
        Vector3d centre = middle(positions);
        Vector3d best = new Vector3d(centre);
        double bestSquared = Double.POSITIVE_INFINITY;
        for (int step = 1; step <= STEPS; step++) {
            int farthest = farthest(positions, centre);
            double squared = squaredDistance(positions, farthest, centre);
            if (squared < bestSquared) {
                bestSquared = squared;
                best.set(centre);
            }
            double fraction = 1.0 / (step + 1);
            centre.lerp(new Vector3d(positions[farthest], positions[farthest + 1], positions[farthest + 2]), fraction);
        }
        return new BoundingSphere(Vec3.of(best), Math.sqrt(bestSquared) * (1 + 1e-12));
    }

    private static Vector3d middle(float[] positions) {
        var low = new Vector3d(Double.POSITIVE_INFINITY);
        var high = new Vector3d(Double.NEGATIVE_INFINITY);
        for (int i = 0; i < positions.length; i += 3) {
            var point = new Vector3d(positions[i], positions[i + 1], positions[i + 2]);
            low.min(point);
            high.max(point);
        }
        return low.add(high).mul(0.5);
    }

    private static int farthest(float[] positions, Vector3d from) {
        int farthest = 0;
        double most = -1;
        for (int i = 0; i < positions.length; i += 3) {
            double squared = squaredDistance(positions, i, from);
            if (squared > most) {
                most = squared;
                farthest = i;
            }
        }
        return farthest;
    }

    private static double squaredDistance(float[] positions, int at, Vector3d from) {
        return from.distanceSquared(positions[at], positions[at + 1], positions[at + 2]);
    }
}
