package nephele.engine.cloud.field;

import nephele.engine.cloud.noise.EvolvingNoise;
import nephele.engine.level.Cloud;
import nephele.engine.math.Aabb;

/**
 * Clouds of a kind: bodies in plan that narrow towards the top, with billows on them and edges that detail erodes. The
 * inside of f = depth − rise − billows (1 − shape) − 0.35 erosion · detail is cloud, and the density is the body's times
 * min(1, sharpness · f).
 *
 * <p>The depth of a column is that inside of a body in plan. With the noises b and c of bodies and clusters, q = 0.65 b +
 * 0.35 c has the distribution of a sum of two uniform numbers; u, its fraction of smaller values, is uniform again, so
 * that the fraction of the plan with u above 1 − r is r.
 */
public final class ProfiledNoise implements NoiseDensity {
    private static final double EROSION = 0.35;

    /** Relative height at which detail has turned from wisps to billows. */
    private static final double WISPS_TO = 1.0 / 6;

    private static final double BODY_WEIGHT = 0.65;
    private static final double CLUSTER_WEIGHT = 0.35;
    private static final double LEAST_WIDTH = 1e-3;
    private static final double SIDE_SLOPE = 1.3;

    /** How much faster the depth falls outside of a body than inside; anvils end sooner. */
    private static final double OUTSIDE_SLOPE = 1.6;

    private final HeightProfile profile;
    private final NoiseLayouts noises;
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
    ProfiledNoise(Cloud.Density.Noise noise, NoiseLayouts noises, PlanMap map, Aabb bounds) {
        profile = HeightProfile.of(noise.profile(), noise.anvil());
        this.noises = noises;
        coverage = noise.coverage();
        this.map = map;
        erosion = EROSION * noise.erosion();
        heightMetres = bounds.maxY() - bounds.minY();
        halfX = (bounds.maxX() - bounds.minX()) / 2;
        halfZ = (bounds.maxZ() - bounds.minZ()) / 2;
    }

    public HeightProfile profile() {
        return profile;
    }

    public EvolvingNoise shape() {
        return noises.shape();
    }

    public EvolvingNoise detail() {
        return noises.detail();
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
        double mixed = BODY_WEIGHT * noises.bodies().at(x, 0, z)
                + CLUSTER_WEIGHT * noises.clusters().at(x, 0, z);
        double depth = uncut(fractionBelow(mixed), covered(x, z));
        return halfX == Double.POSITIVE_INFINITY ? depth : Math.min(depth, withinSides(x, z));
    }

    /** Returns an upper bound of {@link #bodyDepth} in a rectangle, given by its centre and half its sides. */
    public double greatestBodyDepth(double x, double z, double byX, double byZ) {
        double mixed = BODY_WEIGHT * noises.bodies().greatest(x, 0, z, byX, 0, byZ)
                + CLUSTER_WEIGHT * noises.clusters().greatest(x, 0, z, byX, 0, byZ);
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
        double falloff = profile.falloff();
        double reach = covered * (profile.foot() + (1 + falloff - profile.foot()) * power);
        double depth = (below - 1 + reach) / Math.max(LEAST_WIDTH, Math.min(falloff, reach));
        return depth < 0 ? OUTSIDE_SLOPE * depth : Math.min(1, depth);
    }

    /**
     * Returns the greatest depth that the sides of a volume allow, an upright elliptic cylinder: with ρ the distance from its
     * axis, 1 at the sides, it is 1.3 (1 − ρ²), less what an anvil needs to end at the sides.
     */
    private double withinSides(double x, double z) {
        double squared = squared(x / halfX) + squared(z / halfZ);
        return SIDE_SLOPE * (1 - squared) - profile.spread() * Math.min(1, squared);
    }

    private static double squared(double a) {
        return a * a;
    }

    /** Returns the least depth inside of a body at which there is cloud at some height, in metres over the base. */
    public double leastDepth(double fromY, double toY) {
        return profile.leastRise(fromY / heightMetres, toY / heightMetres);
    }

    @Override
    public double at(double x, double y, double z) {
        return at(bodyDepth(x, z), x, y, z);
    }

    /** Returns the density at a point of a column. @param bodyDepth of the column */
    public double at(double bodyDepth, double x, double y, double z) {
        double height = y / heightMetres;
        double inside = bodyDepth - profile.rise(height);
        if (!(inside > 0)) {
            return 0;
        }
        inside -= profile.billows(height) * (1 - noises.shape().at(x, y, z));
        if (erosion > 0 && inside > 0) {
            inside -= erosion * eroding(noises.detail().at(x, y, z), height);
        }
        return inside > 0 ? profile.body(height) * Math.min(1, profile.sharpness(height) * inside) : 0;
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
        double inside = greatestBodyDepth(x, z, halfX, halfZ) - profile.leastRise(from, to);
        if (!(inside > 0)) {
            return 0;
        }
        inside -= profile.leastBillows(from, to) * (1 - noises.shape().greatest(x, y, z, halfX, halfY, halfZ));
        return inside > 0
                ? profile.greatestBody(from, to) * Math.min(1, profile.greatestSharpness(from, to) * inside)
                : 0;
    }
}
