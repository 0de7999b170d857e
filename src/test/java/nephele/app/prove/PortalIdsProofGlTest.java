package nephele.app.prove;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import nephele.app.draw.IdLevel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The same code as `prove portal-ids`, for two cameras of each level: one at a portal, one along a wall. */
class PortalIdsProofGlTest {
    static List<String> levels() {
        return PortalIdsProof.levels();
    }

    @ParameterizedTest
    @MethodSource("levels")
    void noPixelShowsAnotherSurface(String level) throws Exception {
        var result = new PortalIdsProof(List.of(level)).run(3, 2, Proof.Progress.NONE);
        assertEquals(2, result.units());
        assertEquals(List.of(), result.examples());
    }

    @Test
    void coloursAreOfTheSurfaces() {
        for (int surface : new int[] {0, 1, 77, 4000}) {
            assertEquals(surface, IdLevel.surface(IdLevel.colour(surface)));
        }
    }
}
