package nephele.engine.portal.placement;

import nephele.engine.math.Basis;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;

/**
 * Coordinates of a plane: x to the right and y up as seen from in front, height along the normal {@code axes.back()},
 * all in metres from an origin on the plane, so that a far surface loses no precision.
 */
record PlaneFrame(Vec3 origin, Basis axes) {
    private static final Vec3 UP = new Vec3(0, 1, 0);

    /**
     * Returns a frame with y as near as possible to the world's up; on a horizontal plane, along an axis of the world.
     */
    static PlaneFrame of(Vec3 origin, Vec3 normal) {
        return new PlaneFrame(origin, Portal.facing(normal, UP));
    }

    Vec3 normal() {
        return axes.back();
    }

    double x(Vec3 p) {
        return along(axes.right(), p);
    }

    double y(Vec3 p) {
        return along(axes.up(), p);
    }

    double height(Vec3 p) {
        return along(axes.back(), p);
    }

    private double along(Vec3 axis, Vec3 p) {
        return axis.x() * (p.x() - origin.x()) + axis.y() * (p.y() - origin.y()) + axis.z() * (p.z() - origin.z());
    }

    /** Returns a direction's component along the plane's x. */
    double xOf(Vec3 direction) {
        return axes.right().dot(direction);
    }

    /** Returns a direction's component along the plane's y. */
    double yOf(Vec3 direction) {
        return axes.up().dot(direction);
    }

    Vec3 world(double x, double y) {
        return origin.addScaled(x, axes.right()).addScaled(y, axes.up());
    }

    Vec3 worldDirection(double x, double y) {
        return Directions.unit(Directions.combined(axes.right(), x, axes.up(), y));
    }
}
