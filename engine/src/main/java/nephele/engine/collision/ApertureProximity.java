package nephele.engine.collision;

import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import org.joml.Vector3dc;

/** Decides whether a moving shape comes so near to an aperture that it must collide with the world opened there. */
final class ApertureProximity {
    /** Distance at which the world is opened; larger than the skin at which contact begins. */
    private static final double MARGIN_METRES = 0.02;

    /** A centre at most this far behind the plane counts as in front: it has just come out of the portal. */
    private static final double ROUNDING_METRES = 1e-9;

    private Portal portal;
    private RoundedHull shape;
    private double x;
    private double y;
    private double leastX;
    private double mostX;
    private double leastY;
    private double mostY;

    boolean isActive(Portal of, RoundedHull body, Vector3dc at, Vector3dc path) {
        portal = of;
        shape = body;
        double height = portal.inFront(at.x(), at.y(), at.z());
        if (height < -ROUNDING_METRES) {
            return false;
        }
        Vec3 n = portal.normal();
        double lowest = height + Math.min(0, dot(n, path));
        if (lowest - shape.reachMetres() > MARGIN_METRES || lowest + shape.support(-1, n) > MARGIN_METRES) {
            return false;
        }
        x = portal.across(at.x(), at.y(), at.z());
        y = portal.upward(at.x(), at.y(), at.z());
        double halfX = portal.aperture().widthMetres() / 2 + MARGIN_METRES;
        double halfY = portal.aperture().heightMetres() / 2 + MARGIN_METRES;
        if (!overlaps(portal.frame().right(), x, path, halfX)
                || !overlaps(portal.frame().up(), y, path, halfY)) {
            return false;
        }
        measureBehind(height);
        return isPartBehind() ? isThrough() : !endsAround(height, path);
    }

    /**
     * Returns true if the shape ends with its centre in front of the plane and reaches behind the plane only around the
     * wall's edge.
     */
    private boolean endsAround(double height, Vector3dc path) {
        double atEnd = height + dot(portal.normal(), path);
        if (!(atEnd >= 0)) {
            return false;
        }
        x += dot(portal.frame().right(), path);
        y += dot(portal.frame().up(), path);
        measureBehind(atEnd);
        return isPartBehind() && !isThrough();
    }

    private static double dot(Vec3 axis, Vector3dc v) {
        return axis.x() * v.x() + axis.y() * v.y() + axis.z() * v.z();
    }

    private boolean overlaps(Vec3 axis, double from, Vector3dc path, double half) {
        double along = dot(axis, path);
        return from + Math.min(0, along) + shape.support(-1, axis) <= half
                && from + Math.max(0, along) + shape.support(1, axis) >= -half;
    }

    private boolean isPartBehind() {
        return leastX <= mostX;
    }

    /**
     * Returns true if the part behind the plane overlaps the aperture's bounding rectangle, so that it is not beyond
     * the wall's edge.
     */
    private boolean isThrough() {
        return leastX <= portal.aperture().widthMetres() / 2
                && mostX >= -portal.aperture().widthMetres() / 2
                && leastY <= portal.aperture().heightMetres() / 2
                && mostY >= -portal.aperture().heightMetres() / 2;
    }

    /**
     * Finds the bounding rectangle, in the portal's plane, of the shape's part at the plane or behind it.
     *
     * @param height of the shape's centre in front of the plane
     */
    private void measureBehind(double height) {
        leastX = Double.POSITIVE_INFINITY;
        mostX = Double.NEGATIVE_INFINITY;
        leastY = Double.POSITIVE_INFINITY;
        mostY = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < shape.corePoints(); i++) {
            double depth = -(height + core(i, portal.normal()));
            if (depth > -shape.radiusMetres()) {
                double ahead = Math.max(0, -depth);
                include(i, i, 0, Math.sqrt(shape.radiusMetres() * shape.radiusMetres() - ahead * ahead));
            }
            for (int j = 0; j < i; j++) {
                double other = -(height + core(j, portal.normal()));
                if (Math.min(depth, other) < 0 && Math.max(depth, other) > 0) {
                    include(i, j, depth / (depth - other), shape.radiusMetres());
                }
            }
        }
    }

    private double core(int point, Vec3 axis) {
        return shape.core(point, 0) * axis.x() + shape.core(point, 1) * axis.y() + shape.core(point, 2) * axis.z();
    }

    /** Extends the rectangle by a disc around a point between two core points. */
    private void include(int from, int to, double fraction, double radius) {
        Vec3 right = portal.frame().right();
        Vec3 up = portal.frame().up();
        double across = x + core(from, right) + fraction * (core(to, right) - core(from, right));
        double upward = y + core(from, up) + fraction * (core(to, up) - core(from, up));
        leastX = Math.min(leastX, across - radius);
        mostX = Math.max(mostX, across + radius);
        leastY = Math.min(leastY, upward - radius);
        mostY = Math.max(mostY, upward + radius);
    }
}
