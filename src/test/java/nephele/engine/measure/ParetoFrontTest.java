package nephele.engine.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.OptionalInt;
import java.util.Random;
import java.util.stream.IntStream;
import nephele.engine.measure.ParetoFront.Choice;
import org.junit.jupiter.api.Test;

class ParetoFrontTest {
    @Test
    void namesWhatDominates() {
        var front = new ParetoFront(
                List.of(new Choice(1, 10), new Choice(2, 5), new Choice(3, 7), new Choice(4, 1), new Choice(4, 2)));
        assertEquals(OptionalInt.empty(), front.dominating(0));
        assertEquals(OptionalInt.of(1), front.dominating(2));
        assertEquals(OptionalInt.of(3), front.dominating(4));
        assertTrue(front.holds(1) && front.holds(3));
    }

    /** Equal choices do not exclude each other: nobody has to prefer one. */
    @Test
    void equalChoicesStay() {
        var front = new ParetoFront(List.of(new Choice(1, 1), new Choice(1, 1)));
        assertTrue(front.holds(0) && front.holds(1));
    }

    @Test
    void everyDominatedChoiceIsDominatedByOneOnTheFront() {
        var random = new Random(2);
        var choices = IntStream.range(0, 200)
                .mapToObj(i -> new Choice(random.nextInt(30), random.nextInt(30)))
                .toList();
        var front = new ParetoFront(choices);
        for (int i = 0; i < choices.size(); i++) {
            front.dominating(i).ifPresent(by -> assertTrue(front.holds(by)));
        }
    }

    @Test
    void refusesWhatWasNotMeasured() {
        assertThrows(IllegalArgumentException.class, () -> new Choice(Double.NaN, 1));
    }
}
