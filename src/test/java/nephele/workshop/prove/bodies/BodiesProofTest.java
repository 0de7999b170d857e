package nephele.workshop.prove.bodies;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The proof {@code bodies} holds at a reduced count. CPU time is only printed; the bytes are limited. */
@Execution(ExecutionMode.CONCURRENT)
class BodiesProofTest {
    @Test
    void towerAndStackStand() {
        ProofResult result = new BodiesProof().run(0, 1, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        for (Figure figure : result.figures()) {
            if (figure.unit().equals("B")) {
                assertTrue(figure.value() <= 256, figure.name() + ": " + figure.value());
            }
        }
    }

    @Test
    void stackClosesItsGapsDownwards() {
        BodyRun stack = BodyRun.stack();
        assertEquals(0.2, stack.farthestOff(), 1e-9, "twenty gaps");
        for (int tick = 0; tick < 300; tick++) {
            stack.tick(1 / 120.0);
        }
        assertTrue(stack.farthestOff() <= 0.05, "off by " + stack.farthestOff());
        assertEquals(500, stack.asleep());
    }

    @Test
    void nobodyRestsInTheShaft() {
        BodyRun shaft = BodyRun.restless();
        long crossings = 0;
        for (int tick = 0; tick < 600; tick++) {
            shaft.tick(1 / 120.0);
            crossings += shaft.crossings();
            assertEquals(0, shaft.asleep());
        }
        assertTrue(crossings > 200, "crossings " + crossings);
    }
}
