package nephele.engine.cloud.field;

import nephele.engine.cloud.noise.EvolvingNoise;
import nephele.engine.math.Aabb;

/**
 * The plan of a cloud cover: how deep a column is inside of a cloud's body. With the noises b and c of bodies and
 * clusters, q = 0.65 b + 0.35 c has the distribution of a sum of two uniform numbers; u, its share of smaller values, is
 * uniform again, so that the share of the plan with u above 1 − r is r.
 */
final class CloudBodies {
    private static final double BODY_WEIGHT = 0.65;
    private static final double CLUSTER_WEIGHT = 0.35;

    private static final double LEAST_WIDTH = 1e-3;
    private static final double SIDE_SLOPE = 1.3;

    /** How much faster the depth falls outside of a body than inside; anvils end sooner. */
    private static final double OUTSIDE_SLOPE = 1.6;

    private final EvolvingNoise bodies;
    private final EvolvingNoise clusters;
    private final Coverage coverage;
    private final HeightProfile profile;
    /** Half the widths of the volume, at whose sides bodies end; infinite for a layer. */
    private final double halfX;

    private final double halfZ;

    /**
     * @param volume at whose sides bodies end; {@code null} for a layer
     */
    CloudBodies(NoiseLayouts noises, Coverage coverage, HeightProfile profile, Aabb volume) {
        bodies = noises.bodies();
        clusters = noises.clusters();
        this.coverage = coverage;
        this.profile = profile;
        halfX = volume == null ? Double.POSITIVE_INFINITY : (volume.maxX() - volume.minX()) / 2;
        halfZ = volume == null ? Double.POSITIVE_INFINITY : (volume.maxZ() - volume.minZ()) / 2;
    }

    boolean isEmpty() {
        return coverage.isNowhere();
    }

    /** Returns 1 in the middle of a body, 0 at its edge, less outside. */
    double depth(double x, double z) {
        double mixed = BODY_WEIGHT * bodies.at(x, 0, z) + CLUSTER_WEIGHT * clusters.at(x, 0, z);
        double depth = uncut(share(mixed), coverage.at(x, z));
        return halfX == Double.POSITIVE_INFINITY ? depth : Math.min(depth, withinSides(x, z));
    }

    /** Returns an upper bound of the depth in a rectangle, given by its centre and half its sides. */
    double greatest(double x, double z, double byX, double byZ) {
        double mixed = BODY_WEIGHT * bodies.greatest(x, 0, z, byX, 0, byZ)
                + CLUSTER_WEIGHT * clusters.greatest(x, 0, z, byX, 0, byZ);
        double depth = uncut(share(mixed), coverage.greatest(x, z, byX, byZ));
        return halfX == Double.POSITIVE_INFINITY
                ? depth
                : Math.min(depth, withinSides(Math.max(0, Math.abs(x) - byX), Math.max(0, Math.abs(z) - byZ)));
    }

    /** Returns the share of columns with a smaller mixed value. */
    private static double share(double mixed) {
        double tails = 2 * BODY_WEIGHT * CLUSTER_WEIGHT;
        if (mixed < CLUSTER_WEIGHT) {
            return mixed * mixed / tails;
        }
        return mixed <= BODY_WEIGHT
                ? (mixed - CLUSTER_WEIGHT / 2) / BODY_WEIGHT
                : 1 - (1 - mixed) * (1 - mixed) / tails;
    }

    /** Returns the depth, which grows with both arguments. */
    private double uncut(double share, double covered) {
        double power = covered * covered;
        power *= power;
        power *= power;
        power *= power;
        double falloff = profile.falloff();
        double reach = covered * (profile.foot() + (1 + falloff - profile.foot()) * power);
        double depth = (share - 1 + reach) / Math.max(LEAST_WIDTH, Math.min(falloff, reach));
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
}
