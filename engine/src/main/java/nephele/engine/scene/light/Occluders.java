package nephele.engine.scene.light;

import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.math.ItemRayTest;
import nephele.engine.math.Ray;
import nephele.engine.math.SpatialIndex;

/**
 * Answers whether a half-line meets any convex solid. Solids are tested as what lies behind all their planes: exact at
 * edges, so that touching solids leave no gap. Immutable and safe to share between threads.
 */
final class Occluders {
    private final double[][] planes;
    private final SpatialIndex index;

    Occluders(List<Brush> brushes) {
        planes = brushes.stream().map(brush -> brush.shape().flatPlanes()).toArray(double[][]::new);
        index = SpatialIndex.of(brushes.stream().map(b -> b.shape().bounds()).toList());
    }

    /** Inside or on the surface of a solid other than {@code except}. */
    boolean isInside(double[] p, int except) {
        for (int i = 0; i < planes.length; i++) {
            if (i != except && behindAll(planes[i], p)) {
                return true;
            }
        }
        return false;
    }

    private static boolean behindAll(double[] solid, double[] p) {
        for (int i = 0; i < solid.length; i += 4) {
            if (solid[i] * p[0] + solid[i + 1] * p[1] + solid[i + 2] * p[2] > solid[i + 3]) {
                return false;
            }
        }
        return true;
    }

    /** Whether the half-line from {@code o} along {@code d} meets a solid other than {@code except}. */
    boolean isOccluded(double[] o, double[] d, int except) {
        return index.anyHit(
                new Ray(o[0], o[1], o[2], d[0], d[1], d[2]),
                Double.MAX_VALUE,
                (ray, item, limit) -> answer(item != except && meetsSolid(planes[item], o, d, limit)));
    }

    /** For callers that keep their test: whether it hits any solid up to {@code limit}. */
    boolean anyHit(Ray ray, double limit, ItemRayTest test) {
        return index.anyHit(ray, limit, test);
    }

    /** The answer of such a test for one solid. */
    double hit(int solid, double[] o, double[] d, double limit) {
        return answer(meetsSolid(planes[solid], o, d, limit));
    }

    /** Whether a single solid meets every segment from {@code o} to {@code o + segments[i]}. */
    boolean oneMeetsAllSegments(double[] o, double[][] segments) {
        double[] first = segments[0];
        return index.anyHit(
                new Ray(o[0], o[1], o[2], first[0], first[1], first[2]),
                1,
                (ray, item, limit) -> answer(meetsAll(planes[item], o, segments)));
    }

    private static double answer(boolean hit) {
        return hit ? 0 : Double.POSITIVE_INFINITY;
    }

    private static boolean meetsAll(double[] solid, double[] o, double[][] segments) {
        for (double[] segment : segments) {
            if (!meetsSolid(solid, o, segment, 1)) {
                return false;
            }
        }
        return true;
    }

    /** Clips o + t · d, 0 ≤ t ≤ length, by every plane (Cyrus and Beck 1978); what is left lies inside. */
    private static boolean meetsSolid(double[] solid, double[] o, double[] d, double length) {
        double enter = 0;
        double leave = length;
        for (int i = 0; i < solid.length; i += 4) {
            double along = solid[i] * d[0] + solid[i + 1] * d[1] + solid[i + 2] * d[2];
            double distance = solid[i + 3] - solid[i] * o[0] - solid[i + 1] * o[1] - solid[i + 2] * o[2];
            if (along > 0) {
                leave = Math.min(leave, distance / along);
            } else if (along < 0) {
                enter = Math.max(enter, distance / along);
            } else if (distance < 0) {
                return false;
            }
            if (enter > leave) {
                return false;
            }
        }
        return true;
    }
}
