package nephele.engine.cloud.cells;

import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;

/**
 * The part of a ray in the bounds of a cloud. The twin of {@code cloud-span.glsl}. A layer bends around the planet below the
 * eye: at a distance t from an eye at height e, a ray at elevation a has a height h over a planet of radius R with t² / 2R +
 * t sin a (1 + e / R) = (h − e) (1 + (h + e) / 2R).
 */
record StackSpan(double fromMetres, double toMetres) {
    static StackSpan of(Aabb box, double planetRadiusMetres, Ray ray) {
        double bend = 1 / (2 * planetRadiusMetres);
        double eye = ray.originY();
        StackSpan heights = betweenHeights(
                bend, slope(bend, ray), over(bend, eye, box.minY() - eye), over(bend, eye, box.maxY() - eye));
        return behindPlanet(heights, bend, ray)
                .between(ray.originX(), ray.directionX(), box.minX(), box.maxX())
                .between(ray.originZ(), ray.directionZ(), box.minZ(), box.maxZ());
    }

    private static double slope(double bend, Ray ray) {
        return ray.directionY() * (1 + 2 * bend * ray.originY());
    }

    /** Returns the constant of the quadratic equation for a height that is so much above the eye's. */
    private static double over(double bend, double eye, double above) {
        return -above * (1 + bend * (2 * eye + above));
    }

    /** Returns the height over the planet, or over level ground if its radius is infinite, at a distance. */
    static double height(double planetRadiusMetres, Ray ray, double metres) {
        double bend = 1 / (2 * planetRadiusMetres);
        double above = metres * (slope(bend, ray) + bend * metres);
        return ray.originY() + above / (1 + bend * (2 * ray.originY() + above));
    }

    private static StackSpan behindPlanet(StackSpan span, double bend, Ray ray) {
        if (bend == 0 || ray.originY() < 0) {
            return span;
        }
        double ground = sooner(bend, slope(bend, ray), over(bend, ray.originY(), -ray.originY()));
        return new StackSpan(span.fromMetres, Math.min(span.toMetres, ground));
    }

    /**
     * Returns the first part of a ray between two heights.
     *
     * @param bend factor of the distance's square in the quadratic equation, 0 over level ground
     * @param slope that of the distance
     * @param overBase its constant for the lower height: how far the eye is over it; {@code overTop} for the upper one
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
