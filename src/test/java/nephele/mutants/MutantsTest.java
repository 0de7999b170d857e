package nephele.mutants;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import nephele.workshop.prove.process.MutantsProof;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

@Execution(ExecutionMode.CONCURRENT)
class MutantsTest {
    private static final String VEC3 = "engine/src/main/java/nephele/engine/math/Vec3.java";

    @TempDir
    private Path folder;

    @Test
    void everyFaultStillHasItsPlace() throws IOException {
        for (Mutant mutant : Mutants.ALL) {
            assertFalse(mutant.mutated().isEmpty());
            assertTrue(MutantRun.testClass(mutant.killer()).endsWith("Test"));
        }
        assertEquals(
                Mutants.ALL.size(),
                Mutants.ALL.stream().map(Mutant::name).distinct().count());
        assertEquals(new MutantsProof().claim().fullCount(), Mutants.ALL.size());
    }

    /**
     * A mutant is refused, neither killed nor survived, if its text does not occur exactly once, its replacement
     * changes nothing, or its test is not found.
     */
    @ParameterizedTest
    @CsvSource({
        "no such text, x, math/Vec3Test",
        "double, float, math/Vec3Test",
        "toVector(), toVector(), math/Vec3Test",
        "toVector(), x(), NoSuchTest",
        "toVector(), x(), WalkTest"
    })
    void aFaultWithoutItsPlaceOrItsTestIsRefused(String text, String replacement, String killer) {
        Mutant mutant = new Mutant(Mutant.Area.MODEL, "none", VEC3, text, replacement, killer);
        assertThrows(IOException.class, () -> new MutantRun(folder).judge(mutant));
    }

    /** These planted faults are found; {@code ./nephele prove mutants} runs all of them. */
    @ParameterizedTest
    @ValueSource(strings = {"a leaf drops the item after a hidden one", "light is added where it should be covered"})
    void aPlantedFaultIsFound(String name) throws IOException, InterruptedException {
        Mutant mutant = Mutants.ALL.stream()
                .filter(m -> m.name().equals(name))
                .findFirst()
                .orElseThrow();
        MutantRun.Verdict verdict = new MutantRun(folder).judge(mutant);
        assertTrue(verdict.killed(), verdict::toString);
    }

    @Test
    void aChangeWithoutConsequenceSurvives() throws IOException, InterruptedException {
        Mutant harmless = new Mutant(
                Mutant.Area.CULLING,
                "harmless",
                VEC3,
                "return new Vector3d(x, y, z);",
                "return new Vector3d(x + 0, y, z);",
                "Vec3Test");
        assertFalse(new MutantRun(folder).judge(harmless).killed());
    }
}
