package nephele.engine.cloud.light;

import java.util.Arrays;
import java.util.stream.IntStream;
import nephele.engine.cloud.DeltaScaling;
import nephele.engine.cloud.TwoStreamSlab;
import nephele.engine.math.GaussLegendre;

/**
 * The factor on the diffuse light of {@link TwoStreamSlab} with which the radiance that leaves a slab carries the fluxes
 * of {@link SlabDoubling}. Eddington's light is too weak near the lit side, so that the formal solution of the transport
 * equation would lose up to a tenth of the energy, and a slab reflects up to a sixth less of a low sun. The factor is linear
 * in the depth; two unknowns meet two fluxes, except for thin slabs, where one factor keeps the energy.
 */
final class SlabCorrection {
    private static final int THICKNESSES = 20;
    private static final int COSINES = 12;
    /** Ratio of successive thicknesses, the first of which is 1. */
    private static final double RATIO = Math.sqrt(2);

    /** The number of doublings from a slab in which light is scattered once to the first of the table. */
    private static final int FIRST_DOUBLINGS = 22;

    private static final double GREATEST = 4;
    /** Fraction of the fluxes that is aimed at, below 1: no error of the quadrature may make light. */
    private static final double KEPT = 0.9988;

    private static final GaussLegendre ZENITH = new GaussLegendre(32);
    private static final int AZIMUTHS = 24;
    private static final int STEPS = 40;

    private final DeltaScaling medium;
    private final SmallAngleScattering smallAngles;
    private final double[] atTop = new double[THICKNESSES * COSINES];
    private final double[] slope = new double[THICKNESSES * COSINES];

    SlabCorrection(CloudOptics optics, SmallAngleScattering smallAngles) {
        medium = optics.scaled();
        this.smallAngles = smallAngles;
        double[][] reflected = new double[THICKNESSES][COSINES];
        double[][] passed = new double[THICKNESSES][COSINES];
        IntStream.range(0, 2).parallel().forEach(chain -> putFluxes(optics, chain, reflected, passed));
        IntStream.range(0, atTop.length).parallel().forEach(index -> {
            int row = index / COSINES;
            int column = index % COSINES;
            fit(row, column, reflected[row][column], passed[row][column]);
        });
    }

    /** Puts the fluxes of every second thickness: each is twice as thick as the one before. */
    private static void putFluxes(CloudOptics optics, int first, double[][] reflected, double[][] passed) {
        double[] cosines = new double[COSINES];
        Arrays.setAll(cosines, SlabCorrection::cosine);
        var slabs = new SlabDoubling(optics, Math.pow(RATIO, first) / (1 << FIRST_DOUBLINGS), cosines);
        for (int doubling = 0; doubling < FIRST_DOUBLINGS; doubling++) {
            slabs.addToItself();
        }
        for (int row = first; row < THICKNESSES; row += 2) {
            for (int column = 0; column < COSINES; column++) {
                reflected[row][column] = slabs.reflectance(column);
                passed[row][column] = slabs.transmittance(column);
            }
            slabs.addToItself();
        }
    }

    private static double cosine(int column) {
        return (column + 1.0) / COSINES;
    }

    /** Fluxes out of the lit and the far side: without diffuse light, with that of the source, and with it × depth. */
    private static final class Fluxes {
        private final double[] direct = new double[2];
        private final double[] even = new double[2];
        private final double[] growing = new double[2];
    }

    private void fit(int row, int column, double reflectance, double transmittance) {
        int index = row * COSINES + column;
        double thickness = Math.pow(RATIO, row);
        double cosine = cosine(column);
        var slab = TwoStreamSlab.underBeam(medium, thickness, cosine);
        double unscattered = Math.exp(-thickness / cosine);
        double straight = Math.exp(-medium.depthFactor() * thickness / cosine);
        double reflected = KEPT * reflectance;
        double transmitted = KEPT * (transmittance - straight) + straight - unscattered;
        Fluxes fluxes = fluxes(slab, thickness, cosine);
        double missingAbove = reflected - fluxes.direct[0];
        double missingBelow = transmitted - fluxes.direct[1];
        double one = (missingAbove + missingBelow) / (fluxes.even[0] + fluxes.even[1]);
        double determinant = fluxes.even[0] * fluxes.growing[1] - fluxes.growing[0] * fluxes.even[1];
        double top = (missingAbove * fluxes.growing[1] - fluxes.growing[0] * missingBelow) / determinant;
        double rise = (fluxes.even[0] * missingBelow - missingAbove * fluxes.even[1]) / determinant;
        double thick = clamped(Math.log(thickness) / Math.log(2), 0, 1);
        atTop[index] = clamped(one + thick * (clamped(top, -1, GREATEST) - one), 0, GREATEST);
        slope[index] = thick * clamped(rise, -GREATEST, GREATEST);
    }

    private Fluxes fluxes(TwoStreamSlab slab, double thickness, double cosine) {
        var fluxes = new Fluxes();
        var above = smallAngles.steps(STEPS);
        var below = smallAngles.steps(STEPS);
        for (int node = 0; node < ZENITH.nodes.length; node++) {
            double mu = ZENITH.nodes[node];
            double weight = 2 * Math.PI * mu * ZENITH.weights[node] / cosine;
            addDiffuse(fluxes, slab, new Exit(0, mu, -mu * cosine, weight), thickness, cosine);
            addDiffuse(fluxes, slab, new Exit(1, mu, mu * cosine, weight), thickness, cosine);
            double sines = Math.sqrt((1 - mu * mu) * (1 - cosine * cosine));
            double fraction = weight / AZIMUTHS;
            setNarrow(above, new Exit(0, mu, -mu * cosine, fraction), thickness, cosine);
            setNarrow(below, new Exit(1, mu, mu * cosine, fraction), thickness, cosine);
            for (int azimuth = 0; azimuth < AZIMUTHS; azimuth++) {
                double level = sines * Math.cos((azimuth + 0.5) * Math.PI / AZIMUTHS);
                fluxes.direct[0] = above.addedTo(fluxes.direct[0], 2 - 2 * (level - mu * cosine));
                fluxes.direct[1] = below.addedTo(fluxes.direct[1], 2 - 2 * (level + mu * cosine));
            }
        }
        return fluxes;
    }

    /**
     * A direction in which light leaves the slab.
     *
     * @param side 0 for the lit one
     * @param mu its cosine with the normal of the side
     * @param turned cosine of the angle to the beam, or its mean over azimuths
     */
    private record Exit(int side, double mu, double turned, double weight) {
        /** Returns where a step ends; steps grow with the distance from the side. */
        double inside(double reach, int step) {
            return reach * step * step / (STEPS * STEPS);
        }

        double depth(double inside, double thickness) {
            return side == 0 ? inside : thickness - inside;
        }
    }

    /**
     * Adds the flux of light that is linear in the cosine of an angle. On the mean over azimuths the flow along the beam is as
     * much as {@link CloudLight} takes from the flow along the normal.
     */
    private void addDiffuse(Fluxes fluxes, TwoStreamSlab slab, Exit exit, double thickness, double cosine) {
        double scale = medium.depthFactor();
        double alongBeam = medium.g() * exit.turned;
        double down = medium.g() * (exit.side == 0 ? -exit.mu : exit.mu);
        double reach = Math.min(thickness, 24 * exit.mu / scale);
        for (int step = 0; step < STEPS; step++) {
            double from = exit.inside(reach, step);
            double to = exit.inside(reach, step + 1);
            double depth = exit.depth((from + to) / 2, thickness);
            double taken = Math.exp(-scale * from / exit.mu) * -Math.expm1(-scale * (to - from) / exit.mu);
            double emitted = exit.weight * taken * medium.albedo();
            double once = (1 + 3 * alongBeam) / (4 * Math.PI) * Math.exp(-scale * depth / cosine);
            double diffuse = Math.max(0, cosine * (slab.diffuseMean(depth) + down * slab.diffuseSlope(depth)));
            fluxes.direct[exit.side] += emitted * once;
            fluxes.even[exit.side] += emitted * diffuse;
            fluxes.growing[exit.side] += emitted * diffuse * depth / thickness;
        }
    }

    /** Sets the steps of light that turns by small angles; their depths are the same at all azimuths of an exit. */
    private void setNarrow(SmallAngleScattering.Steps steps, Exit exit, double thickness, double cosine) {
        double reach = Math.min(thickness, smallAngles.deepest() * exit.mu);
        for (int step = 0; step < STEPS; step++) {
            double from = exit.inside(reach, step);
            double to = exit.inside(reach, step + 1);
            double inside = (from + to) / 2;
            double path = exit.depth(inside, thickness) / cosine + inside / exit.mu;
            steps.set(step, path, exit.weight * (to - from) / exit.mu);
        }
    }

    private static double clamped(double x, double least, double most) {
        return Math.max(least, Math.min(most, x));
    }

    /**
     * Returns the factor.
     *
     * @param depth below the lit side, along the normal, not scaled
     */
    double factor(double depth, double thickness, double cosine) {
        if (!(thickness > 0)) {
            return 1;
        }
        double x = clamped(Math.log(thickness) / Math.log(RATIO), 0, THICKNESSES - 1.001);
        double y = clamped(cosine * COSINES - 1, 0, COSINES - 1.001);
        int row = (int) x;
        int column = (int) y;
        double fraction = Math.min(1, depth / thickness);
        return Math.max(
                0,
                mixed(atTop, row, column, x - row, y - column)
                        + fraction * mixed(slope, row, column, x - row, y - column));
    }

    private static double mixed(double[] table, int row, int column, double u, double v) {
        int at = row * COSINES + column;
        double thin = table[at] + v * (table[at + 1] - table[at]);
        double thick = table[at + COSINES] + v * (table[at + COSINES + 1] - table[at + COSINES]);
        return thin + u * (thick - thin);
    }
}
