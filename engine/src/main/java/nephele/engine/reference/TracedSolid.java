package nephele.engine.reference;

import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import org.joml.Vector3dc;

/** A convex solid as an intersection of half-spaces: exact at edges, so that touching solids leave no gap. */
final class TracedSolid implements TracedShape {
    /** Two faces with parameters that differ by less than this share are hit on their common edge. */
    private static final double EDGE = 1e-12;

    private final double[] planes;
    private final Aabb bounds;

    TracedSolid(ConvexPolyhedron shape) {
        planes = shape.flatPlanes();
        bounds = shape.bounds();
    }

    @Override
    public Aabb bounds() {
        return bounds;
    }

    @Override
    public double entry(Ray ray, double least) {
        return entry(ray, planes, least);
    }

    @Override
    public boolean intersects(Ray ray, double limit) {
        return meets(ray, planes, limit);
    }

    @Override
    public boolean shadesItself() {
        return false;
    }

    @Override
    public SurfacePoint at(EyePath path, Vec3 place, Vector3dc toEye, SurfaceAppearance looks) {
        return looks.solids().at(path.item(), face(path.ray()), place, toEye);
    }

    /**
     * Returns the index of the face by which the ray enters; on an edge, of the face at the smaller angle of incidence.
     */
    int face(Ray ray) {
        double[] p = planes;
        int entered = 0;
        double latest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < p.length; i += 4) {
            double rate = rate(ray, p, i);
            double parameter = -inFront(ray, p, i) / rate;
            double same = EDGE * Math.abs(parameter);
            boolean isSquarer = parameter > latest - same && rate < rate(ray, p, 4 * entered);
            if (rate < 0 && (parameter > latest + same || isSquarer)) {
                latest = parameter;
                entered = i / 4;
            }
        }
        return entered;
    }

    /** Returns the parameter at which the ray enters; infinity if that is before {@code least}, or never. */
    private static double entry(Ray ray, double[] p, double least) {
        double enter = Double.NEGATIVE_INFINITY;
        double leave = Double.POSITIVE_INFINITY;
        for (int i = 0; i < p.length && enter <= leave; i += 4) {
            double rate = rate(ray, p, i);
            double front = inFront(ray, p, i);
            if (rate < 0) {
                enter = Math.max(enter, -front / rate);
            } else if (rate > 0) {
                leave = Math.min(leave, -front / rate);
            } else if (front > 0) {
                return Double.POSITIVE_INFINITY;
            }
        }
        return enter < leave && enter >= least ? enter : Double.POSITIVE_INFINITY;
    }

    /** Clips the ray from 0 to {@code limit} by every plane (Cyrus and Beck 1978): the rest is inside. */
    private static boolean meets(Ray ray, double[] p, double limit) {
        double enter = 0;
        double leave = limit;
        for (int i = 0; i < p.length && enter <= leave; i += 4) {
            double rate = rate(ray, p, i);
            double front = inFront(ray, p, i);
            if (rate < 0) {
                enter = Math.max(enter, -front / rate);
            } else if (rate > 0) {
                leave = Math.min(leave, -front / rate);
            } else if (front > 0) {
                return false;
            }
        }
        return enter <= leave;
    }

    private static double rate(Ray ray, double[] p, int plane) {
        return p[plane] * ray.directionX() + p[plane + 1] * ray.directionY() + p[plane + 2] * ray.directionZ();
    }

    private static double inFront(Ray ray, double[] p, int plane) {
        return p[plane] * ray.originX() + p[plane + 1] * ray.originY() + p[plane + 2] * ray.originZ() - p[plane + 3];
    }
}
