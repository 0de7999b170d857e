package nephele.engine.cloud;

import java.util.SplittableRandom;

/**
 * The distribution of scattered directions, per steradian; its integral over the sphere is 1. It is a function of the
 * separation |d − l|² = 2 − 2 cos θ of the unit directions of propagation before and after, from 0 (forwards) to 4
 * (backwards): near the forward peak this keeps digits that cos θ loses.
 */
public interface PhaseFunction {
    /** Returns the probability density per steradian. */
    double perSteradian(double separation);

    /** Returns the separation of a random direction of this distribution. */
    double sampleSeparation(SplittableRandom random);
}
