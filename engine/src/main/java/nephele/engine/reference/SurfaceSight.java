package nephele.engine.reference;

import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import org.joml.Vector3dc;

/** Which surface the eye sees: what identity colours show, without any light. One for each thread. */
public final class SurfaceSight {
    /** The sky, or what is beyond the far plane. */
    public static final int NOTHING = -1;

    /** What a drawn picture's depths cannot tell apart. */
    private static final double SAME_METRES = 1e-5;

    /** Share of the way to a light that its rays leave out at the surface. */
    private static final double LIFT = 1e-7;

    private final SurfaceRays rays;
    private final EyePath path;
    private final EyePath straight;
    private final Pinhole eye;
    private final Vector3dc from;

    SurfaceSight(SurfaceRays rays, EyePath path, Pinhole eye) {
        this.rays = rays;
        this.path = path;
        straight = new EyePath(rays, Portals.NONE, ReflectingFaces.NONE);
        this.eye = eye;
        from = eye.eye().toVector();
    }

    /**
     * The index of the solid that a ray ends on, or the number of solids plus the index of a body, or the number of both
     * plus the index of a model, or {@link #NOTHING}.
     *
     * @param right 0 at the left border of the picture, 1 at the right one; {@code up} likewise from the bottom
     */
    public int at(double right, double up) {
        if (!path.walk(from, eye.direction(right, up), eye.nearMetres(), eye.farMetres())) {
            return NOTHING;
        }
        return rays.surface(path.item());
    }

    /**
     * Whether a solid's surface is as near as the one that was seen by the last {@link #at}: of faces that lie in one
     * place any may be said to be seen.
     */
    public boolean coincides(int solid) {
        return path.item() >= 0
                && rays.isSolid(solid)
                && Math.abs(rays.entry(path.ray(), solid) - path.end())
                                * path.direction().length()
                        <= SAME_METRES;
    }

    /** Stands for the portals and mirrors that the ray of the last {@link #at} met, in their order; 0 for none. */
    public long passed() {
        return path.passed();
    }

    /** Where the ray of the last {@link #at} that met something ended. */
    public Vec3 place() {
        return path.ray().at(path.end());
    }

    /**
     * Whether light arrives where the last {@link #at} ended, from a place shifted by a little: what shades is as the
     * level has it, the thing itself does not.
     *
     * @param way to the light from the place that is not shifted
     * @param limit share of the way that counts; infinite for the sun
     */
    public boolean isLit(Vec3 shift, Vec3 way, double limit) {
        Vec3 p = place();
        Ray ray = new Ray(
                p.x() + shift.x() + LIFT * way.x(),
                p.y() + shift.y() + LIFT * way.y(),
                p.z() + shift.z() + LIFT * way.z(),
                way.x() - (limit == 1 ? shift.x() : 0),
                way.y() - (limit == 1 ? shift.y() : 0),
                way.z() - (limit == 1 ? shift.z() : 0));
        return rays.blocker(ray, limit, rays.withoutOwnShade(path.item())) < 0;
    }

    /** How far one can go straight on without meeting anything, portals and mirrors taken as walls; infinite into the open. */
    public double freeMetres(Vec3 place, Vec3 unitDirection) {
        straight.walk(place.toVector(), unitDirection.toVector(), 0, Double.POSITIVE_INFINITY);
        return straight.metres();
    }
}
