package nephele.workshop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.app.command.Captured;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ProveCommandTest {
    @Test
    void aUnitIsRepeatedByItsNumber() {
        var run = Captured.run("prove", "rotations", "--from", "7", "--count", "2");
        assertEquals(0, run.exitCode(), run.err());
        assertTrue(run.out().startsWith("rotations: holds after 2 of "), run.out());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "prove rotations --from 7",
                "prove --from 7 --count 1",
                "prove rotations --from 7 --count 1 --record",
                "prove rotations --from 7 --count 1 --again",
                "prove rotations --from -1 --count 1"
            })
    void unitsAloneNeedAProofAndACountAndAreNotKept(String line) {
        var run = Captured.run(line.split(" "));
        assertEquals(2, run.exitCode(), run.out());
        assertTrue(run.err().contains("--from"), run.err());
    }
}
