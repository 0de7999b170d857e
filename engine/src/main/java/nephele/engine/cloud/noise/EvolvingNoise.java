package nephele.engine.cloud.noise;

import nephele.engine.level.Cloud;
import nephele.engine.math.Hash64;
import nephele.engine.math.Vec3;

/**
 * A table laid out in space, at one moment: turned around the vertical, scaled, and shifted by random offsets that
 * another generation of the noise replaces by others. Between two generations a and b at angle φ of 0 to π/2 the value
 * is ½ + (a − ½) cos φ + (b − ½) sin φ, at least 0 and at most 1, which keeps the variance (Heitz and Neyret 2018,
 * "High-Performance By-Example Noise using a Histogram-Preserving Blending Operator", equation 2).
 *
 * <p>A cloud has up to four of them. Their periods are in rational proportions and their turns have rational cosines, so that
 * the whole pattern repeats after {@link #PERIOD_FEATURES} features along x and z; it does not appear to, because no two of
 * them repeat together before.
 */
public final class EvolvingNoise {
    /** Generations after which the first one returns. */
    public static final int GENERATIONS = 1024;

    /** Period of a cloud's pattern in features. */
    public static final int PERIOD_FEATURES = 260 * CloudTables.SHAPE_CELLS;

    private static final double DETAIL_PERIODS = 5.0 / 33;
    private static final double BODY_PERIODS = 13.0 / 2;
    private static final double CLUSTER_PERIODS = 20;

    private final PeriodicTable table;
    private final double periodMetres;
    private final double cosine;
    private final double sine;
    private final double[] from;
    private final double[] to;
    private final double weightFrom;
    private final double weightTo;

    /**
     * Lays out a table. A turn by a rational angle keeps the pattern periodic.
     *
     * @param periodMetres edge of the table's cube
     * @param cosine of the turn around the vertical
     * @param sine of the turn
     * @param seed of the offsets
     * @param generation of the noise, at least 0; a fraction is between two of them
     */
    public EvolvingNoise(
            PeriodicTable table, double periodMetres, double cosine, double sine, long seed, double generation) {
        this.table = table;
        this.periodMetres = periodMetres;
        this.cosine = cosine;
        this.sine = sine;
        double whole = Math.floor(generation);
        double angle = (generation - whole) * Math.PI / 2;
        from = offset(seed, (long) whole);
        to = offset(seed, (long) whole + 1);
        weightFrom = StrictMath.cos(angle);
        weightTo = StrictMath.sin(angle);
    }

    /** Returns the billows of one feature of a cloud at a time. */
    public static EvolvingNoise shape(
            Cloud.Density.Noise noise, CloudTables tables, double evolutionSeconds, double seconds) {
        return new EvolvingNoise(
                tables.shape(), period(noise), 1, 0, 4 * noise.seed(), generation(seconds, evolutionSeconds));
    }

    /** Returns the wisps and small billows of a cloud at a time. */
    public static EvolvingNoise detail(
            Cloud.Density.Noise noise, CloudTables tables, double evolutionSeconds, double seconds) {
        return new EvolvingNoise(
                tables.detail(),
                period(noise) * DETAIL_PERIODS,
                1,
                0,
                4 * noise.seed() + 1,
                generation(seconds, evolutionSeconds / 2));
    }

    /** Returns the bodies of a cloud in plan at a time. */
    public static EvolvingNoise bodies(
            Cloud.Density.Noise noise, CloudTables tables, double evolutionSeconds, double seconds) {
        return new EvolvingNoise(
                tables.plan(),
                period(noise) * BODY_PERIODS,
                3.0 / 5,
                4.0 / 5,
                4 * noise.seed() + 2,
                generation(seconds, evolutionSeconds * 4));
    }

    /** Returns the clusters of a cloud's bodies in plan at a time. */
    public static EvolvingNoise clusters(
            Cloud.Density.Noise noise, CloudTables tables, double evolutionSeconds, double seconds) {
        return new EvolvingNoise(
                tables.plan(),
                period(noise) * CLUSTER_PERIODS,
                5.0 / 13,
                12.0 / 13,
                4 * noise.seed() + 3,
                generation(seconds, evolutionSeconds * 16));
    }

    private static double period(Cloud.Density.Noise noise) {
        return CloudTables.SHAPE_CELLS * noise.featureMetres();
    }

    /** Returns the generation at a time, a multiple of the generations' number nearer to 0 than that. */
    private static double generation(double seconds, double secondsEach) {
        double all = GENERATIONS * secondsEach;
        if (!(secondsEach > 0) || !Double.isFinite(seconds)) {
            return 0;
        }
        double into = seconds % all;
        return (into < 0 ? into + all : into) / secondsEach;
    }

    private static double[] offset(long seed, long generation) {
        long hash = Hash64.combine(seed, Math.floorMod(generation, (long) GENERATIONS));
        double[] offset = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            offset[axis] = (Hash64.combine(hash, axis) >>> 40) * 0x1p-24;
        }
        return offset;
    }

    public PeriodicTable table() {
        return table;
    }

    /** Returns the edge of the table's cube. */
    public double periodMetres() {
        return periodMetres;
    }

    /** Returns the offset of the generation that fades, in periods. */
    public Vec3 fadingOffset() {
        return new Vec3(from[0], from[1], from[2]);
    }

    /** Returns the offset of the generation that comes, in periods. */
    public Vec3 comingOffset() {
        return new Vec3(to[0], to[1], to[2]);
    }

    /** Returns the weight of the deviation from ½ of the generation that fades. */
    public double fadingWeight() {
        return weightFrom;
    }

    /** Returns the weight of the deviation from ½ of the generation that comes. */
    public double comingWeight() {
        return weightTo;
    }

    /** Returns the value at a point of the pattern, 0 to 1. */
    public double at(double x, double y, double z) {
        double u = (cosine * x - sine * z) / periodMetres;
        double v = y / periodMetres;
        double w = (sine * x + cosine * z) / periodMetres;
        double first = table.at(u + from[0], v + from[1], w + from[2]);
        if (weightTo == 0) {
            return first;
        }
        return blended(first, table.at(u + to[0], v + to[1], w + to[2]));
    }

    private double blended(double a, double b) {
        return Math.max(0, Math.min(1, 0.5 + weightFrom * (a - 0.5) + weightTo * (b - 0.5)));
    }

    /** Returns an upper bound of the values in a box of the pattern, given by its centre and half its sides. */
    public double greatest(double x, double y, double z, double halfX, double halfY, double halfZ) {
        double u = (cosine * x - sine * z) / periodMetres;
        double v = y / periodMetres;
        double w = (sine * x + cosine * z) / periodMetres;
        double du = (Math.abs(cosine) * halfX + Math.abs(sine) * halfZ) / periodMetres;
        double dv = halfY / periodMetres;
        double dw = (Math.abs(sine) * halfX + Math.abs(cosine) * halfZ) / periodMetres;
        double first = greatest(from, u, v, w, du, dv, dw);
        return weightTo == 0 ? first : blended(first, greatest(to, u, v, w, du, dv, dw));
    }

    private double greatest(double[] offset, double u, double v, double w, double du, double dv, double dw) {
        double a = u + offset[0];
        double b = v + offset[1];
        double c = w + offset[2];
        return table.greatest(a - du, b - dv, c - dw, a + du, b + dv, c + dw);
    }
}
