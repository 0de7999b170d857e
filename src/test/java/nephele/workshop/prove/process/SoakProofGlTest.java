package nephele.workshop.prove.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.workshop.prove.proof.Proof;
import org.junit.jupiter.api.Test;

/**
 * Allocations are within their limits in one second of {@code prove soak} on a small picture; only the full run judges
 * pauses.
 */
class SoakProofGlTest {
    @Test
    void framesAndTicksStayWithinTheirBytes() {
        var result = new SoakProof(160, 90).run(0, 1, Proof.Progress.NONE);
        assertEquals(1, result.units());
        var bytes = result.examples().stream()
                .filter(example -> example.contains("bytes"))
                .toList();
        assertTrue(bytes.isEmpty(), bytes.toString());
        assertTrue(result.figures().stream().anyMatch(figure -> figure.name().equals("frames") && figure.value() > 0));
    }
}
