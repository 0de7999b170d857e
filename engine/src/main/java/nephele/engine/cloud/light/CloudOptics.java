package nephele.engine.cloud.light;

import java.util.SplittableRandom;
import nephele.engine.cloud.DeltaScaling;
import nephele.engine.cloud.HenyeyGreenstein;
import nephele.engine.cloud.PhaseFunction;
import nephele.engine.level.Cloud;

/**
 * How a cloud scatters light: its albedo and a phase function of two lobes after Henyey and Greenstein.
 *
 * @param albedo scattering divided by extinction, 0 to 1
 * @param g asymmetry of the forward lobe
 * @param backG asymmetry of the other lobe
 * @param backFraction fraction of light that the other lobe scatters, 0 to 1
 */
public record CloudOptics(double albedo, double g, double backG, double backFraction) implements PhaseFunction {
    private static final int MOST_MIXED = 40;

    /** Returns the optics of a cloud of a level. */
    public static CloudOptics of(Cloud cloud) {
        Cloud.BackLobe back = cloud.backLobe();
        return new CloudOptics(cloud.albedo(), cloud.phaseG(), back.phaseBackG(), back.phaseBackShare());
    }

    /** Returns optics with one lobe. */
    public static CloudOptics of(double albedo, double g) {
        return new CloudOptics(albedo, g, 0, 0);
    }

    /** Returns the Legendre moment of the phase function, 1 for degree 0. */
    double moment(int degree) {
        return (1 - backFraction) * Math.pow(g, degree) + backFraction * Math.pow(backG, degree);
    }

    /** Returns the mean cosine of the scattering angle. */
    public double meanCosine() {
        return moment(1);
    }

    /** Returns the fraction of scattered light that counts as forward; never so much that the rest turns backwards. */
    public double forwardFraction() {
        return Math.min(moment(2), Math.max(0, moment(1)));
    }

    /** Returns the medium whose forward peak counts as unscattered. */
    public DeltaScaling scaled() {
        return DeltaScaling.of(albedo, meanCosine(), forwardFraction());
    }

    @Override
    public double perSteradian(double separation) {
        double forward = new HenyeyGreenstein(g).perSteradian(separation);
        return backFraction == 0
                ? forward
                : (1 - backFraction) * forward + backFraction * new HenyeyGreenstein(backG).perSteradian(separation);
    }

    @Override
    public double sampleSeparation(SplittableRandom random) {
        double asymmetry = backFraction > 0 && random.nextDouble() < backFraction ? backG : g;
        return new HenyeyGreenstein(asymmetry).sampleSeparation(random);
    }

    /** Returns the fraction of light that is scattered into the cone around its direction whose edge has a separation. */
    public double fractionWithin(double separation) {
        return (1 - backFraction) * new HenyeyGreenstein(g).fractionWithin(separation)
                + backFraction * new HenyeyGreenstein(backG).fractionWithin(separation);
    }

    /**
     * Returns the distribution of directions after a number of scatterings, per steradian. Lobes of Henyey and Greenstein
     * remain such lobes: their asymmetries multiply. After many scatterings nothing is left of two different lobes.
     */
    double afterScatterings(int count, double separation) {
        if (backFraction == 0 || count > MOST_MIXED) {
            return new HenyeyGreenstein(Math.pow(meanCosine(), count)).perSteradian(separation);
        }
        double sum = 0;
        double choose = 1;
        for (int back = 0; back <= count; back++) {
            double fraction = choose * Math.pow(1 - backFraction, count - back) * Math.pow(backFraction, back);
            if (fraction > 0) {
                double asymmetry = Math.pow(g, count - back) * Math.pow(backG, back);
                sum += fraction * new HenyeyGreenstein(asymmetry).perSteradian(separation);
            }
            choose *= (count - back) / (back + 1.0);
        }
        return sum;
    }
}
