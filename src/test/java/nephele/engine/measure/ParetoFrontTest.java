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
        var front = front(0, 1, 10, 2, 5, 3, 7, 4, 1, 4, 2);
        assertEquals(OptionalInt.empty(), front.dominating(0));
        assertEquals(OptionalInt.of(1), front.dominating(2));
        assertEquals(OptionalInt.of(3), front.dominating(4));
        assertTrue(isOn(front, 1) && isOn(front, 3));
    }

    /** Equal choices do not dominate each other. */
    @Test
    void equalChoicesStay() {
        var front = front(0, 1, 1, 1, 1);
        assertTrue(isOn(front, 0) && isOn(front, 1));
    }

    /** With a step of 0.5, an error smaller by 0.1 neither justifies a higher cost nor prevents domination. */
    @Test
    void errorsWithinAStepAreEqual() {
        var front = front(0.5, 1, 1, 2, 0.9, 3, 0.3);
        assertTrue(isOn(front, 0) && isOn(front, 2));
        assertEquals(OptionalInt.of(0), front.dominating(1));
    }

    /** Costs with overlapping intervals are not distinguished: neither dominates without a smaller error. */
    @Test
    void whatIsInDoubtDominatesNothing() {
        var cheap = new Choice(new Interval(0.9, 1, 1.1), 5);
        var dear = new Choice(new Interval(1.05, 1.2, 1.3), 5);
        var better = new Choice(new Interval(1.05, 1.2, 1.3), 4);
        assertTrue(isOn(new ParetoFront(List.of(cheap, dear), 0, 0), 1));
        assertEquals(OptionalInt.of(1), new ParetoFront(List.of(dear, better), 0, 0).dominating(0));
        assertTrue(isOn(new ParetoFront(List.of(cheap, better), 0, 0), 0));
    }

    /** Among many comparisons some differ by chance, so a cost difference below the step does not dominate. */
    @Test
    void costsWithinAStepAreEqual() {
        var almost = List.of(exact(0.98, 1), exact(1, 1), exact(1.1, 1));
        var front = new ParetoFront(almost, 0, 0.03);
        assertTrue(isOn(front, 1));
        assertEquals(OptionalInt.of(0), front.dominating(2));
    }

    @Test
    void everyDominatedChoiceIsDominatedByOneOnTheFront() {
        var random = new Random(2);
        var choices = IntStream.range(0, 200)
                .mapToObj(i -> exact(random.nextInt(30), random.nextInt(30)))
                .toList();
        var front = new ParetoFront(choices, 0, 0);
        for (int i = 0; i < choices.size(); i++) {
            front.dominating(i).ifPresent(by -> assertTrue(isOn(front, by)));
        }
    }

    @Test
    void refusesWhatWasNotMeasured() {
        assertThrows(IllegalArgumentException.class, () -> exact(Double.NaN, 1));
    }

    private static ParetoFront front(double errorStep, double... costsAndErrors) {
        return new ParetoFront(
                IntStream.range(0, costsAndErrors.length / 2)
                        .mapToObj(i -> exact(costsAndErrors[2 * i], costsAndErrors[2 * i + 1]))
                        .toList(),
                errorStep,
                0);
    }

    private static Choice exact(double cost, double error) {
        return new Choice(new Interval(cost, cost, cost), error);
    }

    private static boolean isOn(ParetoFront front, int index) {
        return front.dominating(index).isEmpty();
    }
}
