package nephele.workshop.prove.cloud;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.List;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Slabs reflect and transmit what the table says, in 24 of its 360 rows. */
@Execution(ExecutionMode.CONCURRENT)
class CloudSlabsProofTest {
    private static final int ANGLES = 5;
    private static final int DEPTHS = 12;

    /** For each of the six media four depths with an angle; each depth occurs twice. */
    private static final int[][][] DEPTH_AND_ANGLE = {
        {{0, 2}, {3, 0}, {6, 1}, {8, 1}},
        {{1, 0}, {4, 2}, {7, 3}, {9, 4}},
        {{2, 3}, {5, 1}, {8, 4}, {10, 2}},
        {{0, 4}, {3, 1}, {6, 4}, {9, 4}},
        {{1, 4}, {4, 4}, {7, 2}, {11, 1}},
        {{2, 0}, {5, 3}, {10, 3}, {11, 4}}
    };

    @Test
    void slabsReflectAndTransmitWhatTheTableSays() {
        var proof = new CloudSlabsProof();
        ProofResult result = Arrays.stream(rows())
                .parallel()
                .mapToObj(proof::compared)
                .reduce(ProofResult.NOTHING, ProofResult::and);
        assertEquals(List.of(), result.examples());
        assertEquals(24 * 4, result.value("fluxes"));
    }

    private static int[] rows() {
        int[] rows = new int[24];
        for (int i = 0; i < rows.length; i++) {
            int[] chosen = DEPTH_AND_ANGLE[i / 4][i % 4];
            rows[i] = (i / 4 * DEPTHS + chosen[0]) * ANGLES + chosen[1];
        }
        return rows;
    }
}
