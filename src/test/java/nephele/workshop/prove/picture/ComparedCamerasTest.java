package nephele.workshop.prove.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import nephele.host.terminal.CommandFailure;
import nephele.host.terminal.ExitCode;
import nephele.workshop.prove.picture.ComparedCameras.Visit;
import nephele.workshop.prove.proof.Proof;
import org.junit.jupiter.api.Test;

class ComparedCamerasTest {
    private static final List<String> FILES = List.of("a", "b", "c");

    @Test
    void everyLevelsTurnComesBeforeTheNextCameras() throws Exception {
        var cameras = new ComparedCameras(FILES, 5);
        assertEquals(
                List.of(new Visit("a", 3, 2), new Visit("b", 0, 5), new Visit("c", 0, 5), new Visit("a", 5, 1)),
                cameras.visits(3, 13));
        assertEquals(List.of(new Visit("b", 7, 1)), cameras.visits(22, 1));
        assertEquals(List.of(new Visit("c", 1, 1)), new ComparedCameras(FILES, 1).visits(5, 1));
    }

    @Test
    void everyCameraOfEveryLevelComesOnce() throws Exception {
        var cameras = new ComparedCameras(FILES, 5);
        Set<String> seen = new HashSet<>();
        for (long unit = 0; unit < cameras.all(); unit++) {
            var visit = cameras.visits(unit, 1).get(0);
            seen.add(visit.file() + " " + visit.first());
        }
        assertEquals(150, seen.size());
        assertEquals(150, cameras.visits(0, 150).stream().mapToInt(Visit::count).sum());
    }

    @Test
    void withoutLevelsThereIsNothingToCompare() {
        var nowhere = new ComparedCameras(List.of(), 5);
        assertThrows(CommandFailure.class, () -> nowhere.visits(0, 1));
        assertEquals(
                ExitCode.ENVIRONMENT,
                assertThrows(CommandFailure.class, nowhere::all).exitCode());
    }

    /** Without levels there would be no units, of which none fails. */
    @Test
    void withoutLevelsAProofOfPicturesCannotEvenBegin() {
        for (Proof proof : List.of(
                new PortalIdsProof(List.of()), new PortalLightProof(List.of(), 16, 1, Path.of("build", "nowhere")))) {
            var e = assertThrows(
                    CommandFailure.class,
                    () -> proof.claim().fullCount(),
                    proof.claim().name());
            assertTrue(e.getMessage().contains("checkout"), e.getMessage());
        }
    }

    @Test
    void turnsThatDoNotDivideTheCamerasAreRefused() {
        for (int atOnce : new int[] {-5, 0, 3, 51, 100}) {
            assertThrows(IllegalArgumentException.class, () -> new ComparedCameras(FILES, atOnce));
        }
    }
}
