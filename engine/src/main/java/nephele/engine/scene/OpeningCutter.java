package nephele.engine.scene;

import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;

/** Apertures as views see them. */
final class OpeningCutter {
    /** Times the picture: what is cut off must not show at its edges after rounding to float. */
    private static final double BEYOND_PICTURE = 1.05;

    /** A portal in the plane that a view looks out of is its rear, whatever rounding says. */
    private static final double IN_PLANE_METRES = 1e-6;

    private OpeningCutter() {}

    /**
     * Fills {@code opening} with what of the aperture lies before the view's plane, nearer than its far plane and in its
     * picture, empty when it is seen from behind or not at all.
     */
    static void cut(View view, Portal portal, double openness, PicturePolygon opening) {
        opening.clear();
        if (!(portal.inFront(view.eyeX(), view.eyeY(), view.eyeZ()) > 0) || !(openness > 0)) {
            return;
        }
        Aperture aperture = portal.aperture();
        Projection projection = view.projection();
        double tanAcross = projection.tanHalfWidth();
        double tanUp = projection.tanHalfHeight();
        for (int i = 0; i < aperture.corners(); i++) {
            double across = openness * aperture.cornerX(i);
            double upward = openness * aperture.cornerY(i);
            double x = corner(
                    portal.centre().x() - view.eyeX(),
                    portal.frame().right().x(),
                    portal.frame().up().x(),
                    across,
                    upward);
            double y = corner(
                    portal.centre().y() - view.eyeY(),
                    portal.frame().right().y(),
                    portal.frame().up().y(),
                    across,
                    upward);
            double z = corner(
                    portal.centre().z() - view.eyeZ(),
                    portal.frame().right().z(),
                    portal.frame().up().z(),
                    across,
                    upward);
            opening.add(view.alongRight(x, y, z) / tanAcross, view.alongUp(x, y, z) / tanUp, -view.alongBack(x, y, z));
        }
        if (view.clip() != null) {
            if (reachBefore(view.clip(), portal, openness) <= IN_PLANE_METRES) {
                opening.clear();
                return;
            }
            keepBefore(view, view.clip(), opening);
        }
        if (projection.farMetres() < Double.POSITIVE_INFINITY) {
            opening.keepNearer(projection.farMetres());
        }
        opening.keepInPicture(BEYOND_PICTURE);
    }

    /** Metres by which the aperture reaches before a plane. */
    private static double reachBefore(Plane plane, Portal portal, double openness) {
        double alongRight = dot(portal.frame().right(), plane.nx(), plane.ny(), plane.nz());
        double alongUp = dot(portal.frame().up(), plane.nx(), plane.ny(), plane.nz());
        double reach = openness * portal.aperture().reach(alongRight, alongUp);
        return plane.signedDistance(portal.centre()) + reach;
    }

    private static double corner(double centre, double right, double up, double across, double upward) {
        return centre + across * right + upward * up;
    }

    private static double dot(Vec3 axis, double x, double y, double z) {
        return axis.x() * x + axis.y() * y + axis.z() * z;
    }

    /** The plane does not pass through the eye, so in the picture's coordinates it has a fourth term. */
    private static void keepBefore(View view, Plane plane, PicturePolygon opening) {
        Projection projection = view.projection();
        opening.keep(
                view.alongRight(plane.nx(), plane.ny(), plane.nz()) * projection.tanHalfWidth(),
                view.alongUp(plane.nx(), plane.ny(), plane.nz()) * projection.tanHalfHeight(),
                -view.alongBack(plane.nx(), plane.ny(), plane.nz()),
                plane.signedDistance(view.eyeX(), view.eyeY(), view.eyeZ()));
    }
}
