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
 * @param backShare share of light that the other lobe scatters, 0 to 1
 */
public record CloudOptics(double albedo, double g, double backG, double backShare) implements PhaseFunction {
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
        return (1 - backShare) * Math.pow(g, degree) + backShare * Math.pow(backG, degree);
    }

    /** Returns the mean cosine of the scattering angle. */
    public double meanCosine() {
        return moment(1);
    }

    /** Returns the share of scattered light that counts as forward; never so much that the rest turns backwards. */
    public double forwardShare() {
        return Math.min(moment(2), Math.max(0, moment(1)));
    }

    /** Returns the medium whose forward peak counts as unscattered. */
    public DeltaScaling scaled() {
        return DeltaScaling.of(albedo, meanCosine(), forwardShare());
    }

    @Override
    public double perSteradian(double separation) {
        double forward = new HenyeyGreenstein(g).perSteradian(separation);
        return backShare == 0
                ? forward
                : (1 - backShare) * forward + backShare * new HenyeyGreenstein(backG).perSteradian(separation);
    }

    @Override
    public double sampleSeparation(SplittableRandom random) {
        double asymmetry = backShare > 0 && random.nextDouble() < backShare ? backG : g;
        return new HenyeyGreenstein(asymmetry).sampleSeparation(random);
    }

    /** Returns the share of light that is scattered into the cone around its direction whose edge has a separation. */
    public double shareWithin(double separation) {
        return (1 - backShare) * new HenyeyGreenstein(g).shareWithin(separation)
                + backShare * new HenyeyGreenstein(backG).shareWithin(separation);
    }

    /**
     * Returns the distribution of directions after a number of scatterings, per steradian. Lobes of Henyey and Greenstein
     * remain such lobes: their asymmetries multiply. After many scatterings nothing is left of two different lobes.
     */
    double afterScatterings(int count, double separation) {
        if (backShare == 0 || count > MOST_MIXED) {
            return new HenyeyGreenstein(Math.pow(meanCosine(), count)).perSteradian(separation);
        }
        double sum = 0;
        double choose = 1;
        for (int back = 0; back <= count; back++) {
            double share = choose * Math.pow(1 - backShare, count - back) * Math.pow(backShare, back);
            if (share > 0) {
                double asymmetry = Math.pow(g, count - back) * Math.pow(backG, back);
                sum += share * new HenyeyGreenstein(asymmetry).perSteradian(separation);
            }
            choose *= (count - back) / (back + 1.0);
        }
        return sum;
    }
}
