package nephele.engine.cloud.field;

import java.util.function.DoubleUnaryOperator;
import nephele.engine.cloud.noise.CloudTables;
import nephele.engine.cloud.noise.EvolvingNoise;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudProfile;
import nephele.engine.math.Aabb;

/**
 * Clouds of a kind: bodies in plan that narrow towards the top, with billows on them and edges that detail erodes. The
 * inside of f = depth − rise − billows (1 − shape) − 0.35 erosion · detail is cloud, and the density is the body's times
 * min(1, sharpness · f).
 *
 * <p>The depth of a column is that inside of a body in plan. With the noises b and c of bodies and clusters, q = 0.65 b +
 * 0.35 c has the distribution of a sum of two uniform numbers; u, its fraction of smaller values, is uniform again, so
 * that the fraction of the plan with u above 1 − r is r.
 *
 * <p>Rise, billows, sharpness and the body's density are functions of the height, 0 at the base and 1 at the top, by kind of
 * cloud. They are linear between {@link #KNOTS} equidistant heights, as a one-dimensional texture is.
 */
public final class ProfiledNoise implements NoiseDensity {
    public static final int KNOTS = 33;

    private static final double EROSION = 0.35;

    /** Relative height at which detail has turned from wisps to billows. */
    private static final double WISPS_TO = 1.0 / 6;

    private static final double BODY_WEIGHT = 0.65;
    private static final double CLUSTER_WEIGHT = 0.35;
    private static final double LEAST_WIDTH = 1e-3;
    private static final double SIDE_SLOPE = 1.3;

    /** How much faster the depth falls outside of a body than inside; anvils end sooner. */
    private static final double OUTSIDE_SLOPE = 1.6;

    /** How far outside of a body a full anvil reaches. */
    private static final double ANVIL_SPREAD = 0.75;

    /** Width of a body's edge, as a fraction of the plan. */
    private final double falloff;
    /** The fraction of the plan in which bodies begin, per fraction of the sky that is covered in the end. */
    private final double foot;
    /** How far outside of a body the cloud reaches, in the units of {@link #bodyDepth}. */
    private final double spread;
    /** The depth that a body must exceed to reach a height. */
    private final double[] rise;
    /** How deep the shape noise dents the surface. */
    private final double[] billows;
    /** The growth of density with depth. */
    private final double[] sharpness;
    /** The greatest density. */
    private final double[] body;

    private final EvolvingNoise shape;
    private final EvolvingNoise detail;
    private final EvolvingNoise bodies;
    private final EvolvingNoise clusters;
    private final double coverage;

    /** Factor on the coverage by place; {@code null} for none. */
    private final PlanMap map;

    private final double erosion;
    private final double heightMetres;

    /** Half the widths of the volume, at whose sides bodies end; infinite for a layer. */
    private final double halfX;

    private final double halfZ;

    /**
     * @param noise with a profile
     * @param map {@code null} for none
     * @param bounds infinite in x and z for a layer
     */
    ProfiledNoise(
            Cloud.Density.Noise noise,
            CloudTables tables,
            double evolutionSeconds,
            double seconds,
            PlanMap map,
            Aabb bounds) {
        CloudProfile kind = noise.profile();
        double anvil = kind == CloudProfile.CUMULONIMBUS ? noise.anvil() : 0;
        falloff = kind == CloudProfile.STRATUS ? 0.3 : 0.8;
        foot = kind == CloudProfile.STRATUS ? 1.2 : 1.22 - 0.3 * anvil;
        spread = ANVIL_SPREAD * anvil;
        rise = knots(h -> rise(kind, anvil, h));
        billows = knots(h -> billows(kind, anvil, h));
        sharpness = knots(h -> sharpness(kind, anvil, h));
        body = knots(h -> body(kind, anvil, h));
        shape = EvolvingNoise.shape(noise, tables, evolutionSeconds, seconds);
        detail = EvolvingNoise.detail(noise, tables, evolutionSeconds, seconds);
        bodies = EvolvingNoise.bodies(noise, tables, evolutionSeconds, seconds);
        clusters = EvolvingNoise.clusters(noise, tables, evolutionSeconds, seconds);
        coverage = noise.coverage();
        this.map = map;
        erosion = EROSION * noise.erosion();
        heightMetres = bounds.maxY() - bounds.minY();
        halfX = (bounds.maxX() - bounds.minX()) / 2;
        halfZ = (bounds.maxZ() - bounds.minZ()) / 2;
    }

    private static double rise(CloudProfile kind, double anvil, double h) {
        return switch (kind) {
            case STRATUS -> 0.5 * (2 * h - 1) * (2 * h - 1) * (2 * h - 1) * (2 * h - 1);
            case CUMULUS -> h * h;
            case CUMULONIMBUS ->
                0.15
                        + 0.3 * anvil
                        + 0.4 * (1 - 0.5 * anvil) * h * h
                        + (1.3 + 0.5 * anvil) * ramp(0.93, 1, h)
                        - anvil * (ANVIL_SPREAD + 0.6) * ramp(0.76, 0.93, h);
        };
    }

    private static double billows(CloudProfile kind, double anvil, double h) {
        return switch (kind) {
            case STRATUS -> 0.5;
            case CUMULUS -> 0.25 + 0.35 * ramp(0, 0.3, h);
            case CUMULONIMBUS -> 0.45 + 0.15 * ramp(0, 0.2, h) - 0.35 * anvil * ramp(0.78, 0.92, h);
        };
    }

    private static double sharpness(CloudProfile kind, double anvil, double h) {
        return switch (kind) {
            case STRATUS -> 2;
            case CUMULUS -> 6;
            case CUMULONIMBUS -> 6 - 4 * anvil * ramp(0.75, 0.9, h);
        };
    }

    private static double body(CloudProfile kind, double anvil, double h) {
        return switch (kind) {
            case STRATUS -> Math.min(1, Math.min(h / 0.15, (1 - h) / 0.3));
            case CUMULUS -> 0.4 + 0.6 * ramp(0, 0.06, h);
            case CUMULONIMBUS -> (0.4 + 0.6 * ramp(0, 0.04, h)) * (1 - 0.75 * anvil * ramp(0.7, 0.85, h));
        };
    }

    private static double ramp(double from, double to, double at) {
        double t = Math.max(0, Math.min(1, (at - from) / (to - from)));
        return t * t * (3 - 2 * t);
    }

    private static double[] knots(DoubleUnaryOperator function) {
        double[] knots = new double[KNOTS];
        for (int i = 0; i < KNOTS; i++) {
            knots[i] = function.applyAsDouble(i / (KNOTS - 1.0));
        }
        return knots;
    }

    /** Returns rise, billows, sharpness and body at each of {@link #KNOTS} heights, four values a height. */
    public float[] profile() {
        float[] values = new float[4 * KNOTS];
        for (int i = 0; i < KNOTS; i++) {
            values[4 * i] = (float) rise[i];
            values[4 * i + 1] = (float) billows[i];
            values[4 * i + 2] = (float) sharpness[i];
            values[4 * i + 3] = (float) body[i];
        }
        return values;
    }

    public EvolvingNoise shape() {
        return shape;
    }

    public EvolvingNoise detail() {
        return detail;
    }

    /** Returns by how much detail can dent the surface, in the units of {@link #bodyDepth}. */
    public double eroding() {
        return erosion;
    }

    /**
     * Returns how deep a column is inside of a body, by its place in the pattern: 1 in the middle, 0 at the edge, less
     * outside.
     */
    public double bodyDepth(double x, double z) {
        double mixed = BODY_WEIGHT * bodies.at(x, 0, z) + CLUSTER_WEIGHT * clusters.at(x, 0, z);
        double depth = uncut(fractionBelow(mixed), covered(x, z));
        return halfX == Double.POSITIVE_INFINITY ? depth : Math.min(depth, withinSides(x, z));
    }

    /** Returns an upper bound of {@link #bodyDepth} in a rectangle, given by its centre and half its sides. */
    public double greatestBodyDepth(double x, double z, double byX, double byZ) {
        double mixed = BODY_WEIGHT * bodies.greatest(x, 0, z, byX, 0, byZ)
                + CLUSTER_WEIGHT * clusters.greatest(x, 0, z, byX, 0, byZ);
        double depth = uncut(
                fractionBelow(mixed),
                map == null ? coverage : coverage * map.greatest(x - byX, z - byZ, x + byX, z + byZ));
        return halfX == Double.POSITIVE_INFINITY
                ? depth
                : Math.min(depth, withinSides(Math.max(0, Math.abs(x) - byX), Math.max(0, Math.abs(z) - byZ)));
    }

    /** Returns the fraction of the sky that is meant to be covered at a place. */
    private double covered(double x, double z) {
        return map == null ? coverage : coverage * map.at(x, z);
    }

    /** Returns the fraction of columns with a smaller mixed value. */
    private static double fractionBelow(double mixed) {
        double tails = 2 * BODY_WEIGHT * CLUSTER_WEIGHT;
        if (mixed < CLUSTER_WEIGHT) {
            return mixed * mixed / tails;
        }
        return mixed <= BODY_WEIGHT
                ? (mixed - CLUSTER_WEIGHT / 2) / BODY_WEIGHT
                : 1 - (1 - mixed) * (1 - mixed) / tails;
    }

    /** Returns the depth, which grows with both arguments. */
    private double uncut(double below, double covered) {
        double power = covered * covered;
        power *= power;
        power *= power;
        power *= power;
        double reach = covered * (foot + (1 + falloff - foot) * power);
        double depth = (below - 1 + reach) / Math.max(LEAST_WIDTH, Math.min(falloff, reach));
        return depth < 0 ? OUTSIDE_SLOPE * depth : Math.min(1, depth);
    }

    /**
     * Returns the greatest depth that the sides of a volume allow, an upright elliptic cylinder: with ρ the distance from its
     * axis, 1 at the sides, it is 1.3 (1 − ρ²), less what an anvil needs to end at the sides.
     */
    private double withinSides(double x, double z) {
        double squared = squared(x / halfX) + squared(z / halfZ);
        return SIDE_SLOPE * (1 - squared) - spread * Math.min(1, squared);
    }

    private static double squared(double a) {
        return a * a;
    }

    /** Returns the least depth inside of a body at which there is cloud at some height, in metres over the base. */
    public double leastDepth(double fromY, double toY) {
        return least(rise, fromY / heightMetres, toY / heightMetres);
    }

    @Override
    public double at(double x, double y, double z) {
        return at(bodyDepth(x, z), x, y, z);
    }

    /** Returns the density at a point of a column. @param bodyDepth of the column */
    public double at(double bodyDepth, double x, double y, double z) {
        double height = y / heightMetres;
        double inside = bodyDepth - interpolated(rise, height);
        if (!(inside > 0)) {
            return 0;
        }
        inside -= interpolated(billows, height) * (1 - shape.at(x, y, z));
        if (erosion > 0 && inside > 0) {
            inside -= erosion * eroding(detail.at(x, y, z), height);
        }
        return inside > 0 ? interpolated(body, height) * Math.min(1, interpolated(sharpness, height) * inside) : 0;
    }

    @Override
    public boolean isEmpty() {
        return coverage == 0 || map != null && map.isBlack();
    }

    /** Returns the distance from the detail's points, which leaves balls, and its opposite near the base. */
    static double eroding(double detail, double height) {
        double balls = Math.min(1, height / WISPS_TO);
        return 1 - detail + balls * (2 * detail - 1);
    }

    @Override
    public double greatest(double x, double y, double z, double halfX, double halfY, double halfZ) {
        double from = (y - halfY) / heightMetres;
        double to = (y + halfY) / heightMetres;
        double inside = greatestBodyDepth(x, z, halfX, halfZ) - least(rise, from, to);
        if (!(inside > 0)) {
            return 0;
        }
        inside -= least(billows, from, to) * (1 - shape.greatest(x, y, z, halfX, halfY, halfZ));
        return inside > 0 ? greatest(body, from, to) * Math.min(1, greatest(sharpness, from, to) * inside) : 0;
    }

    private static double interpolated(double[] knots, double height) {
        double at = Math.max(0, Math.min(1, height)) * (KNOTS - 1);
        int lower = Math.min((int) at, KNOTS - 2);
        return knots[lower] + (knots[lower + 1] - knots[lower]) * (at - lower);
    }

    private static double least(double[] knots, double from, double to) {
        double least = Math.min(interpolated(knots, from), interpolated(knots, to));
        for (int i = knotAfter(from); i < knotAfter(to); i++) {
            least = Math.min(least, knots[i]);
        }
        return least;
    }

    private static double greatest(double[] knots, double from, double to) {
        double greatest = Math.max(interpolated(knots, from), interpolated(knots, to));
        for (int i = knotAfter(from); i < knotAfter(to); i++) {
            greatest = Math.max(greatest, knots[i]);
        }
        return greatest;
    }

    private static int knotAfter(double height) {
        return (int) Math.ceil(Math.max(0, Math.min(1, height)) * (KNOTS - 1));
    }
}
