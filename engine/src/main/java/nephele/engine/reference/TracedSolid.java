package nephele.engine.reference;

import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Ray;
import nephele.engine.math.RayClip;
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
    public double entry(Ray ray, double least, double most) {
        RayClip inside = clip(ray, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
        return inside.enter() < inside.leave() && inside.enter() >= least ? inside.enter() : Double.POSITIVE_INFINITY;
    }

    @Override
    public boolean intersects(Ray ray, double limit) {
        RayClip inside = clip(ray, 0, limit);
        return inside.enter() <= inside.leave();
    }

    @Override
    public boolean shadesItself() {
        return false;
    }

    @Override
    public SurfacePoint at(EyePath path, Vec3 place, Vector3dc toEye, SurfaceAppearance looks) {
        return looks.solids().at(path.item(), face(path.ray()), place, toEye);
    }

    @Override
    public EmissiveSurfaces.Emitter emitter(int item, SurfaceAppearance looks) {
        return EmissiveSurfaces.of(looks.solids().lit(item, this));
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

    /** Clips the ray by every plane; once nothing is left, the rest is not looked at. */
    private RayClip clip(Ray ray, double enter, double leave) {
        double[] p = planes;
        RayClip clip = new RayClip(ray, enter, leave);
        for (int i = 0; i < p.length && clip.enter() <= clip.leave(); i += 4) {
            clip.keepBehind(rate(ray, p, i), inFront(ray, p, i));
        }
        return clip;
    }

    private static double rate(Ray ray, double[] p, int plane) {
        return p[plane] * ray.directionX() + p[plane + 1] * ray.directionY() + p[plane + 2] * ray.directionZ();
    }

    private static double inFront(Ray ray, double[] p, int plane) {
        return p[plane] * ray.originX() + p[plane + 1] * ray.originY() + p[plane + 2] * ray.originZ() - p[plane + 3];
    }
}
