package nephele.engine.cloud.field;

import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/**
 * A ball of density exp(−d²/2s²) at distance d of its centre, 0 from 5 s on (where it is 4e-6).
 *
 * @param centre world metres
 * @param deviationMetres s, above 0
 */
record GaussianPuff(Vec3 centre, double deviationMetres) {
    private static final double CUT_DEVIATIONS = 5;

    /** Above it the continued fraction of erf converges faster than the series. */
    private static final double SERIES_END = 2.5;

    /** Above it erf is 1 in double precision. */
    private static final double ONE_FROM = 6;

    private static final double TWO_BY_ROOT_PI = 2 / Math.sqrt(Math.PI);
    private static final int FRACTION_TERMS = 60;

    Aabb bounds() {
        double side = 2 * CUT_DEVIATIONS * deviationMetres;
        return Aabb.around(centre, new Vec3(side, side, side));
    }

    double density(double x, double y, double z) {
        double dx = x - centre.x();
        double dy = y - centre.y();
        double dz = z - centre.z();
        return density(dx * dx + dy * dy + dz * dz);
    }

    private double density(double squaredMetres) {
        double ratio = squaredMetres / (deviationMetres * deviationMetres);
        return ratio < CUT_DEVIATIONS * CUT_DEVIATIONS ? StrictMath.exp(-ratio / 2) : 0;
    }

    /** Returns the greatest density in a box. */
    double greatestIn(double minX, double minY, double minZ, double maxX, double maxY, double maxZ) {
        double dx = outside(centre.x(), minX, maxX);
        double dy = outside(centre.y(), minY, maxY);
        double dz = outside(centre.z(), minZ, maxZ);
        return density(dx * dx + dy * dy + dz * dz);
    }

    private static double outside(double at, double min, double max) {
        return Math.max(0, Math.max(min - at, at - max));
    }

    /** Returns the integral of the density, in metres, along a part of a ray of unit direction. */
    double metresAlong(Ray ray, double fromMetres, double toMetres) {
        double ox = centre.x() - ray.originX();
        double oy = centre.y() - ray.originY();
        double oz = centre.z() - ray.originZ();
        double nearest = ox * ray.directionX() + oy * ray.directionY() + oz * ray.directionZ();
        double mx = ox - nearest * ray.directionX();
        double my = oy - nearest * ray.directionY();
        double mz = oz - nearest * ray.directionZ();
        double squared = mx * mx + my * my + mz * mz;
        double cut = CUT_DEVIATIONS * deviationMetres;
        if (!(squared < cut * cut)) {
            return 0;
        }
        double half = Math.sqrt(cut * cut - squared);
        double first = Math.max(fromMetres - nearest, -half);
        double last = Math.min(toMetres - nearest, half);
        if (!(first < last)) {
            return 0;
        }
        double unit = deviationMetres * Math.sqrt(2);
        double fraction = erf(last / unit) - erf(first / unit);
        return density(squared) * deviationMetres * Math.sqrt(Math.PI / 2) * fraction;
    }

    /** Returns erf(x) = 2/√π ∫₀ˣ exp(−t²) dt (Abramowitz and Stegun 1964, chapter 7), with an absolute error below 1e-15. */
    static double erf(double x) {
        double size = Math.abs(x);
        if (size >= ONE_FROM) {
            return Math.signum(x);
        }
        return size <= SERIES_END ? series(x) : Math.signum(x) * (1 - tail(size));
    }

    /** Sums formula 7.1.6, whose terms all have the sign of x. */
    private static double series(double x) {
        double term = x;
        double sum = x;
        for (int n = 1; Math.abs(term) > 1e-17 * Math.abs(sum); n++) {
            term *= 2 * x * x / (2 * n + 1);
            sum += term;
        }
        return TWO_BY_ROOT_PI * StrictMath.exp(-x * x) * sum;
    }

    /** Returns 1 − erf(x) by the continued fraction 7.1.14. */
    private static double tail(double x) {
        double fraction = x;
        for (int n = FRACTION_TERMS; n > 0; n--) {
            fraction = x + n / 2.0 / fraction;
        }
        return StrictMath.exp(-x * x) / (Math.sqrt(Math.PI) * fraction);
    }
}
