package nephele.engine.reference;

import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import org.joml.Vector3dc;

/** Finds the visible surface, as identity colours show it, without light. Use one per thread. */
public final class VisibleSurface {
    /** The sky, or anything beyond the far plane. */
    public static final int NOTHING = -1;

    /** The depth difference that a rendered picture cannot resolve. */
    private static final double SAME_METRES = 1e-5;

    /** The fraction of the distance to a light by which shadow rays start above the surface. */
    private static final double LIFT = 1e-7;

    private final TracedItems rays;
    private final EyePath path;
    private final EyePath straight;
    private final Pinhole eye;
    private final Vector3dc from;

    VisibleSurface(TracedItems rays, EyePath path, Pinhole eye) {
        this.rays = rays;
        this.path = path;
        straight = new EyePath(rays, Portals.NONE, FaceMaterials.NONE);
        this.eye = eye;
        from = eye.eye().toVector();
    }

    /**
     * Returns the index of the solid at the end of a ray, or the number of solids plus the index of a body, or the
     * number of both plus the index of a model, or {@link #NOTHING}.
     *
     * @param right 0 at the left border of the picture, 1 at the right one; {@code up} likewise from the bottom
     */
    public int at(double right, double up) {
        if (!path.trace(from, eye.direction(right, up), eye.nearMetres(), eye.farMetres())) {
            return NOTHING;
        }
        return rays.surface(path.item());
    }

    /**
     * Returns true if a solid's surface is as near as the surface found by the last {@link #at}: of coincident faces
     * any may be the visible one.
     */
    public boolean coincides(int solid) {
        return path.item() >= 0
                && rays.isSolid(solid)
                && Math.abs(rays.entry(path.ray(), solid) - path.end())
                                * path.direction().length()
                        <= SAME_METRES;
    }

    /** Returns a hash of the portals and mirrors on the path of the last {@link #at}, in order; 0 if there are none. */
    public long pathHash() {
        return path.pathHash();
    }

    /** Returns the end point of the last {@link #at} that hit something. */
    public Vec3 place() {
        return path.ray().at(path.end());
    }

    /**
     * Returns true if light reaches the end point of the last {@link #at}, moved by a small shift: other items cast
     * shadows unmoved, the lit item does not shade itself if it is convex.
     *
     * @param toLight vector to the light from the unmoved point
     * @param limit fraction of the distance that counts; infinite for the sun
     */
    public boolean isLit(Vec3 shift, Vec3 toLight, double limit) {
        Vec3 p = place();
        Ray ray = new Ray(
                p.x() + shift.x() + LIFT * toLight.x(),
                p.y() + shift.y() + LIFT * toLight.y(),
                p.z() + shift.z() + LIFT * toLight.z(),
                toLight.x() - (limit == 1 ? shift.x() : 0),
                toLight.y() - (limit == 1 ? shift.y() : 0),
                toLight.z() - (limit == 1 ? shift.z() : 0));
        return rays.blocker(ray, limit, rays.withoutOwnShade(path.item())) < 0;
    }

    /** Returns the free distance along a direction without portals and reflections; infinite if nothing is hit. */
    public double freeMetres(Vec3 place, Vec3 unitDirection) {
        straight.trace(place.toVector(), unitDirection.toVector(), 0, Double.POSITIVE_INFINITY);
        return straight.metres();
    }
}
