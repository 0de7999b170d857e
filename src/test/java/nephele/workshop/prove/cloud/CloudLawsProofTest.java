package nephele.workshop.prove.cloud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.cloud.HenyeyGreenstein;
import nephele.engine.math.GaussLegendre;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.aggregator.ArgumentsAccessor;
import org.junit.jupiter.params.provider.CsvSource;

@Execution(ExecutionMode.CONCURRENT)
class CloudLawsProofTest {
    private static final double FRACTION = 0.004;

    /** All laws with few paths, so with many times the standard error. */
    @Test
    void randomWalksObeyTheLaws() {
        var proof = new CloudLawsProof();
        ProofResult result = IntStream.range(0, proof.all().size())
                .parallel()
                .mapToObj(law -> proof.compared(law, FRACTION, 16 * CloudLaw.MOST_ERROR))
                .reduce(ProofResult.NOTHING, ProofResult::and);
        assertEquals(List.of(), result.examples());
        assertEquals(proof.claim().fullCount(), result.units());
    }

    @Test
    void aWrongLawFails() {
        CloudLaw law = new CloudLawsProof()
                .all().stream()
                        .filter(any -> any.name().equals("transmittance of a slab, depth 1.0, cosine 1.0"))
                        .findFirst()
                        .orElseThrow();
        var wrong = new CloudLaw(law.name(), law.expected() + 0.01, 0, law.paths(), law.estimate());
        assertTrue(law.compared(1, 100_000, 1).holds());
        assertTrue(!wrong.compared(1, 100_000, 1).holds());
        assertTrue(!law.compared(1, 100_000, 1e-9).holds(), "an estimate that is not known well enough fails");
    }

    /** Values of a quadrature with 25 digits: H at five cosines, plane albedo at cosines 1 and 0.5, spherical albedo. */
    @ParameterizedTest
    @CsvSource({
        ".5, 1.07236876, 1.12965309, 1.18773513, 1.22493266, 1.25125956, .11522588, .16014443, .14654438",
        ".8, 1.13880767, 1.26632249, 1.41326257, 1.51816927, 1.59821952, .28525450, .36796976, .34186685",
        ".9, 1.17214305, 1.34327083, 1.55603380, 1.71900056, 1.85009852, .41494748, .50793891, .47802449",
        ".95, 1.19523181, 1.40073989, 1.67178829, 1.89178494, 2.07712384, .53554099, .62617677, .59666878",
        ".99, 1.22487529, 1.48074261, 1.84860102, 2.17539423, 2.47279283, .75272072, .81513990, .79456365",
        ".999, 1.24042477, 1.52616484, 1.95868747, 2.36565956, 2.75607251, .91284533, .93806086, .92971328",
        "1, 1.24735044, 1.54732623, 2.01277877, 2.46345967, 2.90781053, 1, 1, 1"
    })
    void theHFunctionHasItsTabulatedValues(ArgumentsAccessor row) {
        double[] mus = {0.1, 0.25, 0.5, 0.75, 1};
        double albedo = row.getDouble(0);
        for (int i = 0; i < mus.length; i++) {
            assertEquals(row.getDouble(1 + i), CloudLawsProof.hFunction(albedo, mus[i]), 2e-7, "H at " + mus[i]);
        }
        var rule = new GaussLegendre(16);
        double[] albedos = new double[3];
        double moment = 0;
        for (int node = 0; node < rule.nodes.length; node++) {
            double mu = rule.nodes[node];
            double weight = rule.weights[node];
            double here = CloudLawsProof.hFunction(albedo, mu);
            moment += weight * here;
            albedos[0] += weight * 2 * Math.PI * mu * reflected(albedo, mu, here, 1, row.getDouble(5));
            albedos[1] += weight * 2 * Math.PI * mu * reflected(albedo, mu, here, 0.5, row.getDouble(3)) / 0.5;
            albedos[2] += weight * 2 * mu * (1 - here * Math.sqrt(1 - albedo));
        }
        for (int i = 0; i < 3; i++) {
            assertEquals(row.getDouble(6 + i), albedos[i], 3e-5, "albedo " + i);
        }
        assertEquals(2 * (1 - Math.sqrt(1 - albedo)) / albedo, moment, 2e-4, "the mean of H");
    }

    private static double reflected(double albedo, double mu, double here, double mu0, double there) {
        return albedo / (4 * Math.PI) * mu0 / (mu + mu0) * here * there;
    }

    @Test
    void aDeepMediumReflectsItsTabulatedRadiance() {
        double[][] cosines = {{1, 1}, {0.5, 1}, {1, 0.5}, {0.1, 1}};
        double[] conservative = {0.336428168, 0.310499586, 0.155249793, 0.262392876};
        double[] absorbing = {0.240863393, 0.240084981, 0.120042490, 0.216926321};
        for (int i = 0; i < cosines.length; i++) {
            assertEquals(conservative[i], CloudLawsProof.reflected(1, cosines[i][0], cosines[i][1]), 1e-7);
            assertEquals(absorbing[i], CloudLawsProof.reflected(0.99, cosines[i][0], cosines[i][1]), 1e-7);
        }
    }

    /** Radiance by irradiance, scattered once in a slab that scatters evenly and absorbs nothing. */
    @ParameterizedTest
    @CsvSource({
        "1, 1, .000787869756, .00721247417, .0344039159, .0397887357, .0397887358",
        ".5, 1, .00156791314, .0137500204, .0504103617, .0530516477, .0530516477",
        "-1, 1, .000787856625, .00720046739, .0292749158, 3.61281e-05, 0",
        "-.5, 1, .00156786088, .0137043014, .0370105522, 7.22530e-06, 0"
    })
    void lightScatteredOnceHasItsTabulatedRadiance(ArgumentsAccessor row) {
        double[] depths = {0.01, 0.1, 1, 10, 1e4};
        var isotropic = new HenyeyGreenstein(0);
        for (int i = 0; i < depths.length; i++) {
            double expected = row.getDouble(2 + i);
            double found = CloudLawsProof.scatteredOnce(isotropic, row.getDouble(0), row.getDouble(1), depths[i]);
            assertEquals(expected, found, 1e-6 * expected, "depth " + depths[i]);
        }
    }
}
