package nephele.lab.prove.cloud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import nephele.lab.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;

class CloudLawsProofTest {
    private static final double SHARE = 0.004;

    /** All laws with few paths, so with many times the standard error. */
    @Test
    void randomWalksObeyTheLaws() {
        var proof = new CloudLawsProof();
        ProofResult result = IntStream.range(0, proof.laws())
                .parallel()
                .mapToObj(law -> proof.compared(law, SHARE, 16 * CloudLaw.MOST_ERROR))
                .reduce(ProofResult.NOTHING, ProofResult::and);
        assertEquals(List.of(), result.examples());
        assertEquals(proof.claim().fullCount(), result.units());
    }

    @Test
    void aWrongLawFails() {
        CloudLaw law = CloudLaws.all().stream()
                .filter(any -> any.name().equals("transmittance of a slab, depth 1.0, cosine 1.0"))
                .findFirst()
                .orElseThrow();
        var wrong = new CloudLaw(law.name(), law.expected() + 0.01, 0, law.paths(), law.estimate());
        assertTrue(law.compared(1, 100_000, 1).holds());
        assertTrue(!wrong.compared(1, 100_000, 1).holds());
        assertTrue(!law.compared(1, 100_000, 1e-9).holds(), "an estimate that is not known well enough fails");
    }

    /** Values of a quadrature with 25 digits; alpha0 = 2 (1 − √(1 − ϖ)) / ϖ is the mean of H. */
    @Test
    void theHFunctionHasItsTabulatedValues() {
        double[] mus = {0.1, 0.25, 0.5, 0.75, 1};
        double[][] rows = {
            {0.5, 1.07236876, 1.12965309, 1.18773513, 1.22493266, 1.25125956},
            {0.9, 1.17214305, 1.34327083, 1.55603380, 1.71900056, 1.85009852},
            {0.999, 1.24042477, 1.52616484, 1.95868747, 2.36565956, 2.75607251},
            {1, 1.24735044, 1.54732623, 2.01277877, 2.46345967, 2.90781053}
        };
        for (double[] row : rows) {
            for (int i = 0; i < mus.length; i++) {
                assertEquals(row[1 + i], new HFunction(row[0]).at(mus[i]), 2e-7, row[0] + " " + mus[i]);
            }
        }
        assertEquals(0.310499586, new HFunction(1).reflected(0.5, 1), 1e-7);
        double mean = IntStream.range(0, 200)
                .mapToDouble(i -> new HFunction(0.8).at((i + 0.5) / 200))
                .average()
                .orElseThrow();
        assertEquals(2 * (1 - Math.sqrt(0.2)) / 0.8, mean, 1e-5);
    }
}
