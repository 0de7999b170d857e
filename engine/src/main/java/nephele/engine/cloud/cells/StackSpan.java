package nephele.engine.cloud.cells;

import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;

/**
 * The part of a ray in the bounds of a cloud. The twin of {@code insideCloud} in {@code cloud-march.glsl}. Where a layer bends
 * around the planet, a ray at elevation e has the height y + t sin e + t² cos² e / 2R; that holds within 0.3 m up to 30 km
 * and 40 m up to 150 km.
 */
record StackSpan(double fromMetres, double toMetres) {
    static StackSpan of(Aabb box, double planetRadiusMetres, Ray ray) {
        double level = ray.directionX() * ray.directionX() + ray.directionZ() * ray.directionZ();
        double bend = level / (2 * planetRadiusMetres);
        StackSpan heights =
                betweenHeights(bend, ray.directionY(), ray.originY() - box.minY(), ray.originY() - box.maxY());
        return behindPlanet(heights, bend, ray)
                .between(ray.originX(), ray.directionX(), box.minX(), box.maxX())
                .between(ray.originZ(), ray.directionZ(), box.minZ(), box.maxZ());
    }

    private static StackSpan behindPlanet(StackSpan span, double bend, Ray ray) {
        return bend > 0 && ray.originY() >= 0
                ? new StackSpan(span.fromMetres, Math.min(span.toMetres, sooner(bend, ray.directionY(), ray.originY())))
                : span;
    }

    /**
     * Returns the first part of a ray between two heights.
     *
     * @param bend half the second derivative of the height
     * @param slope its first derivative at the eye
     * @param overBase the eye's height over the lower of both; {@code overTop} over the upper one
     */
    static StackSpan betweenHeights(double bend, double slope, double overBase, double overTop) {
        double never = Double.POSITIVE_INFINITY;
        if (overBase < 0) {
            return new StackSpan(later(bend, slope, overBase), later(bend, slope, overTop));
        }
        double down = sooner(bend, slope, overBase);
        if (overTop <= 0) {
            return new StackSpan(0, Math.min(down, later(bend, slope, overTop)));
        }
        double enter = sooner(bend, slope, overTop);
        return enter == never
                ? new StackSpan(never, 0)
                : new StackSpan(enter, Math.min(down, leaving(bend, slope, overTop)));
    }

    /** Returns the greater root for c > 0: where a ray rises again through a height that it has fallen through. */
    private static double leaving(double a, double b, double c) {
        return a > 0 ? (-b + Math.sqrt(Math.max(0, b * b - 4 * a * c))) / (2 * a) : Double.POSITIVE_INFINITY;
    }

    /** Returns the greater root of a t² + b t + c for c ≤ 0: where a ray rises through a height. */
    private static double later(double a, double b, double c) {
        double root = Math.sqrt(Math.max(0, b * b - 4 * a * c));
        double q = b + (b < 0 ? -root : root);
        double t = b < 0
                ? (a > 0 ? -q / (2 * a) : Double.POSITIVE_INFINITY)
                : q > 0 ? -2 * c / q : Double.POSITIVE_INFINITY;
        return Math.max(0, t);
    }

    /** Returns the smaller positive root of a t² + b t + c for c ≥ 0: where a ray falls through a height. */
    private static double sooner(double a, double b, double c) {
        double square = b * b - 4 * a * c;
        return b < 0 && square >= 0 ? 2 * c / (-b + Math.sqrt(square)) : Double.POSITIVE_INFINITY;
    }

    private StackSpan between(double origin, double direction, double min, double max) {
        if (direction == 0) {
            return origin >= min && origin <= max ? this : new StackSpan(Double.POSITIVE_INFINITY, 0);
        }
        double first = ((direction > 0 ? min : max) - origin) / direction;
        double last = ((direction > 0 ? max : min) - origin) / direction;
        return new StackSpan(Math.max(fromMetres, first), Math.min(toMetres, last));
    }
}
