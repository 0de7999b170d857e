package nephele.engine.cloud;

import java.util.SplittableRandom;

/**
 * The phase function of Cornette and Shanks 1992, "Physically reasonable analytic expression for the single-scattering
 * phase function": Henyey and Greenstein's, times 1 + cos² θ, normalised again.
 *
 * @param g parameter, −0.999 to 0.999; 0 gives Rayleigh's phase function
 */
public record CornetteShanks(double g) implements PhaseFunction {
    public CornetteShanks {
        new HenyeyGreenstein(g);
    }

    @Override
    public double perSteradian(double separation) {
        double cosine = 1 - separation / 2;
        return new HenyeyGreenstein(g).perSteradian(separation) * 1.5 * (1 + cosine * cosine) / (2 + g * g);
    }

    /** Rejects directions of Henyey and Greenstein; accepts at least half of them. */
    @Override
    public double sampleSeparation(SplittableRandom random) {
        var proposals = new HenyeyGreenstein(g);
        while (true) {
            double separation = proposals.sampleSeparation(random);
            double cosine = 1 - separation / 2;
            if (2 * random.nextDouble() < 1 + cosine * cosine) {
                return separation;
            }
        }
    }
}
