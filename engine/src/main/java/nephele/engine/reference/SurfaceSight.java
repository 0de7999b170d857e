package nephele.engine.reference;

import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import org.joml.Vector3dc;

/** Which surface the eye sees: what identity colours show, without any light. One for each thread. */
public final class SurfaceSight {
    /** The sky, or what is beyond the far plane. */
    public static final int NOTHING = -1;

    /** What a drawn picture's depths cannot tell apart. */
    private static final double SAME_METRES = 1e-5;

    private final SurfaceRays rays;
    private final EyePath path;
    private final EyePath straight;
    private final Pinhole eye;
    private final Vector3dc from;

    SurfaceSight(SurfaceRays rays, EyePath path, Pinhole eye) {
        this.rays = rays;
        this.path = path;
        straight = new EyePath(rays, Portals.NONE);
        this.eye = eye;
        from = eye.eye().toVector();
    }

    /**
     * The index of the solid that a ray ends on, or the number of solids plus the index of a body, or {@link #NOTHING}.
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

    /** How far one can go straight on without meeting anything, portals taken as walls; infinite into the open. */
    public double freeMetres(Vec3 place, Vec3 unitDirection) {
        straight.walk(place.toVector(), unitDirection.toVector(), 0, Double.POSITIVE_INFINITY);
        return straight.metres();
    }
}
