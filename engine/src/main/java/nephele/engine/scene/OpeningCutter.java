package nephele.engine.scene;

import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/** Clips openings to the part that a view sees. */
final class OpeningCutter {
    /**
     * The clipping bounds as a factor on the picture's: the clipped edges must stay outside after rounding to float.
     */
    private static final double BEYOND_PICTURE = 1.05;

    /**
     * In metres: an opening that reaches no farther than this in front of the view's clip plane is in that plane, up to
     * rounding, and faces away.
     */
    private static final double IN_PLANE_METRES = 1e-6;

    private OpeningCutter() {}

    /**
     * Fills {@code seen} with the part of an opening that is in front of the view's clip plane, nearer than its far
     * plane and in its picture; empties it if the opening faces away or is not visible.
     *
     * @param openness scale of the opening, 0 to 1
     */
    static void cut(View view, Opening opening, double openness, PicturePolygon seen) {
        seen.clear();
        if (!(opening.inFront(view.eyeX(), view.eyeY(), view.eyeZ()) > 0) || !(openness > 0)) {
            return;
        }
        Projection projection = view.projection();
        double tanAcross = projection.tanHalfWidth();
        double tanUp = projection.tanHalfHeight();
        for (int i = 0; i < opening.corners(); i++) {
            // Counter-clockwise in the picture, also in a mirrored one.
            int corner = view.isMirrored() ? opening.corners() - 1 - i : i;
            double across = openness * opening.cornerX(corner);
            double upward = openness * opening.cornerY(corner);
            double x = corner(
                    opening.centre().x() - view.eyeX(),
                    opening.frame().right().x(),
                    opening.frame().up().x(),
                    across,
                    upward);
            double y = corner(
                    opening.centre().y() - view.eyeY(),
                    opening.frame().right().y(),
                    opening.frame().up().y(),
                    across,
                    upward);
            double z = corner(
                    opening.centre().z() - view.eyeZ(),
                    opening.frame().right().z(),
                    opening.frame().up().z(),
                    across,
                    upward);
            seen.add(view.alongRight(x, y, z) / tanAcross, view.alongUp(x, y, z) / tanUp, -view.alongBack(x, y, z));
        }
        if (view.clip() != null) {
            if (reachBefore(view.clip(), opening, openness) <= IN_PLANE_METRES) {
                seen.clear();
                return;
            }
            keepBefore(view, view.clip(), seen);
        }
        if (projection.farMetres() < Double.POSITIVE_INFINITY) {
            seen.keepNearer(projection.farMetres());
        }
        seen.keepInPicture(BEYOND_PICTURE);
    }

    /** Returns the greatest signed distance of an opening's corners to a plane, metres. */
    private static double reachBefore(Plane plane, Opening opening, double openness) {
        double alongRight = dot(opening.frame().right(), plane.nx(), plane.ny(), plane.nz());
        double alongUp = dot(opening.frame().up(), plane.nx(), plane.ny(), plane.nz());
        double reach = openness * opening.reach(alongRight, alongUp);
        return plane.signedDistance(opening.centre()) + reach;
    }

    private static double corner(double centre, double right, double up, double across, double upward) {
        return centre + across * right + upward * up;
    }

    private static double dot(Vec3 axis, double x, double y, double z) {
        return axis.x() * x + axis.y() * y + axis.z() * z;
    }

    /**
     * Keeps the part in front of a plane. The plane does not pass through the eye, so its equation in picture
     * coordinates has a constant term.
     */
    private static void keepBefore(View view, Plane plane, PicturePolygon seen) {
        Projection projection = view.projection();
        seen.keep(
                view.alongRight(plane.nx(), plane.ny(), plane.nz()) * projection.tanHalfWidth(),
                view.alongUp(plane.nx(), plane.ny(), plane.nz()) * projection.tanHalfHeight(),
                -view.alongBack(plane.nx(), plane.ny(), plane.nz()),
                plane.signedDistance(view.eyeX(), view.eyeY(), view.eyeZ()));
    }
}
