package nephele.engine.scene;

import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/** Cuts openings to what a view sees of them. */
final class OpeningCutter {
    /** Times the picture: what is cut off must not show at its edges after rounding to float. */
    private static final double BEYOND_PICTURE = 1.05;

    /** An opening in the plane that a view looks out of is its rear, whatever rounding says. */
    private static final double IN_PLANE_METRES = 1e-6;

    private OpeningCutter() {}

    /**
     * Fills {@code seen} with the part of an opening that lies before the view's plane, nearer than its far plane and in
     * its picture; empties it when the opening is seen from behind or not at all.
     *
     * @param openness scales the opening
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
            // Counter-clockwise in the picture, also where that is mirrored.
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

    /** Metres by which an opening reaches before a plane. */
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

    /** The plane does not pass through the eye, so in the picture's coordinates it has a fourth term. */
    private static void keepBefore(View view, Plane plane, PicturePolygon seen) {
        Projection projection = view.projection();
        seen.keep(
                view.alongRight(plane.nx(), plane.ny(), plane.nz()) * projection.tanHalfWidth(),
                view.alongUp(plane.nx(), plane.ny(), plane.nz()) * projection.tanHalfHeight(),
                -view.alongBack(plane.nx(), plane.ny(), plane.nz()),
                plane.signedDistance(view.eyeX(), view.eyeY(), view.eyeZ()));
    }
}
