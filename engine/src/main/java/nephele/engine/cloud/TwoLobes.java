package nephele.engine.cloud;

import java.util.SplittableRandom;

/**
 * A phase function of two lobes, each after Henyey and Greenstein.
 *
 * @param backShare share of light that the second lobe scatters, 0 to 1
 */
public record TwoLobes(HenyeyGreenstein forward, HenyeyGreenstein back, double backShare) implements PhaseFunction {
    @Override
    public double perSteradian(double separation) {
        return (1 - backShare) * forward.perSteradian(separation) + backShare * back.perSteradian(separation);
    }

    @Override
    public double sampleSeparation(SplittableRandom random) {
        return (random.nextDouble() < backShare ? back : forward).sampleSeparation(random);
    }
}
