package nephele.engine.cloud.noise;

import nephele.engine.math.Hash64;
import nephele.engine.math.Vec3;

/**
 * A table laid out in space, at one moment: turned around the vertical, scaled, and shifted by random offsets that
 * another generation of the noise replaces by others. Between two generations a and b at angle φ of 0 to π/2 the value
 * is ½ + (a − ½) cos φ + (b − ½) sin φ, at least 0 and at most 1, which keeps the variance (Heitz and Neyret 2018,
 * "High-Performance By-Example Noise using a Histogram-Preserving Blending Operator", equation 2).
 */
public final class EvolvingNoise {
    /** Generations after which the first one returns. */
    public static final int GENERATIONS = 1024;

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
        weightFrom = Math.cos(angle);
        weightTo = Math.sin(angle);
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
